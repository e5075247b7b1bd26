import { TimerError } from '../../client/index.js';
import { dateText, messages } from '../messages/index.js';
import { useModels } from '../models.js';
import { Modal } from '../parts/modal.js';
import { MoveServosCheck } from '../parts/move-servos-check.js';
import { NoticeText } from '../parts/notice-bar.js';
import { ProgressLine } from '../parts/progress-line.js';
import { SafetyCheck } from '../parts/safety-check.js';
import type { MemoriesStep, Plan } from '../state/memories.js';

/** A job over several memories: what it is, how far it has come, what became of it. */
export function MemoriesDialog() {
  const { memories } = useModels();
  const current = memories.current.value;
  const { plans } = messages.value.memories;
  return (
    <Modal
      open={current !== null}
      title={current ? plans[current.plan.kind].title : ''}
      titleId="memories-title"
      held={current?.step === 'running'}
      onEscape={() => memories.dismiss()}
    >
      {current?.step === 'review' && <Review plan={current.plan} />}
      {current?.step === 'running' && <Running current={current} />}
      {current?.step === 'done' && <Result current={current} />}
    </Modal>
  );
}

function Review({ plan }: { plan: Plan }) {
  const { session, memories } = useModels();
  const { memories: words, write } = messages.value;
  // Reading changes nothing: only a write asks whether the model is held.
  const ready = plan.kind === 'back-up' || session.safe.value;
  return (
    <>
      <p>{lead(plan)}</p>
      {plan.kind !== 'back-up' && <MoveServosCheck />}
      {plan.kind !== 'back-up' && <SafetyCheck />}
      <div class="buttons">
        <button type="button" class="primary" disabled={!ready} onClick={() => void memories.start()}>
          {words.start[plan.kind]}
        </button>
        <button type="button" onClick={() => memories.dismiss()}>
          {write.cancel}
        </button>
      </div>
    </>
  );
}

function lead(plan: Plan): string {
  const { memories: words, memoryName } = messages.value;
  if (plan.kind === 'back-up') return words.plans['back-up'].lead;
  if (plan.kind === 'copy') return words.plans.copy.lead(memoryName(plan.from), memoryName(plan.to));
  const names = plan.backups.flatMap(({ program: { memory } }) => (memory === null ? [] : [memoryName(memory)]));
  return words.plans.restore.lead(names.join(', '), dateText(plan.backups[0]?.savedAt ?? 0));
}

type StepOf<Step extends MemoriesStep['step']> = Extract<MemoriesStep, { step: Step }>;

function Running({ current }: { current: StepOf<'running'> }) {
  const { memories } = useModels();
  const { memories: words, write, memoryName } = messages.value;
  const { progress, stop } = current;
  const memory = progress?.memory ?? null;
  const stage = progress ? write.stages[progress.stage] : words.plans[current.plan.kind].title;
  const label = memory === null ? stage : words.stage(stage, memoryName(memory));
  return (
    <>
      <ProgressLine label={stop.signal.aborted ? write.stopping : label} progress={progress} />
      <div class="buttons">
        <button type="button" aria-disabled={stop.signal.aborted} onClick={() => memories.dismiss()}>
          {write.stop}
        </button>
      </div>
    </>
  );
}

function Result({ current }: { current: StepOf<'done'> }) {
  const { memories, session } = useModels();
  const { memories: words, write, memoryName, timer } = messages.value;
  const { plan, outcome, kept } = current;
  const { written, saved, stopped, unkept } = outcome;
  const good = stopped === null && kept && written.every(({ report }) => report.result === 'verified');
  return (
    <>
      <div class={`notice ${good ? 'good' : 'bad'}`} role="alert">
        {saved > 0 && <p>{words.saved(saved)}</p>}
        {written.map(({ memory, report }) => (
          <p key={memory}>{words[report.result](memoryName(memory))}</p>
        ))}
        {stopped instanceof TimerError &&
          (stopped.code === 'aborted' ? <p>{words.stopped}</p> : <NoticeText said={timer[stopped.code]} />)}
        {unkept && <NoticeText said={write.move.unkept} />}
        {!kept && <p>{words.notKept}</p>}
      </div>
      <div class="buttons">
        {unkept && (
          <button
            type="button"
            class="primary"
            disabled={!session.connection.value || session.busy.value}
            onClick={() => memories.open(plan)}
          >
            {write.move.again}
          </button>
        )}
        <button type="button" class={unkept ? '' : 'primary'} onClick={() => memories.dismiss()}>
          {write.close}
        </button>
      </div>
    </>
  );
}
