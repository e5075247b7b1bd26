import type { Progress } from '../../client/index.js';
import { valueAt } from '../../program/index.js';
import {
  clockText,
  dateText,
  fieldInSentence,
  fieldName,
  figureText,
  findingText,
  messages,
  type Said,
} from '../messages/index.js';
import { keyFigures } from '../messages/key-figures.js';
import { openValues } from '../session/known.js';
import { memoryText } from '../session/memory-names.js';
import type { Session } from '../session/session.js';
import { Modal } from '../ui/modal.js';
import { NoticeText } from '../ui/notice-text.js';
import { CrossingCheck } from '../write/crossing-check.js';
import { ClosingButtons, JobStep } from '../write/dialog-steps.js';
import { Difference } from '../write/difference.js';
import { MoveServosCheck } from '../write/move-servos-check.js';
import { nextFlightText } from '../write/next-flight-text.js';
import { StartButtons } from '../write/start-buttons.js';
import { UncertainNote } from '../write/uncertain-note.js';
import type { MemoriesStep, MemoryJobs } from './memory-jobs.js';
import { isGood, type MemoriesOutcome, type MemoryChange, type MemoryEnd, type Plan, refusalsOf } from './plan.js';

/** How many uncertain values are named. */
const SHOWN = 4;

/** A job over several memories: its plan, its progress, its result. */
export function MemoriesDialog({ session, jobs }: { readonly session: Session; readonly jobs: MemoryJobs }) {
  const current = jobs.current.value;
  return (
    <Modal
      open={current !== null}
      title={current ? titleOf(current.plan) : ''}
      head={<UncertainNote session={session} />}
      held={jobs.held}
      onEscape={() => jobs.dismiss()}
    >
      {current?.step === 'review' && <Review session={session} jobs={jobs} current={current} />}
      {current?.step === 'running' && (
        <JobStep
          runner={session.runner}
          label={(progress) => runningLabel(current.plan, progress)}
          onStop={() => jobs.dismiss()}
        />
      )}
      {current?.step === 'done' && <Result session={session} jobs={jobs} current={current} />}
    </Modal>
  );
}

type StepOf<Step extends MemoriesStep['step']> = Extract<MemoriesStep, { step: Step }>;

interface ReviewProps {
  readonly session: Session;
  readonly jobs: MemoryJobs;
  readonly current: StepOf<'review'>;
}

function Review({ session, jobs, current: { plan, changes, crossing } }: ReviewProps) {
  const { memories: words } = messages.value;
  const movesServos = changes.some(({ changes: all }) => all.some(({ field }) => field.kind === 'position'));
  return (
    <>
      <Refusals session={session} changes={changes} />
      <CrossingCheck
        crossing={crossing}
        acknowledged={jobs.crossed.value}
        onAcknowledge={(wanted) => jobs.cross(wanted)}
      />
      {movesServos && <MoveServosCheck servoMoves={session.servoMoves} />}
      <p>{leadOf(session, plan)}</p>
      {changes.map((change) => (
        <MemoryDifference key={change.memory} session={session} change={change} folded={changes.length > 1} />
      ))}
      <StartButtons
        safety={plan.kind === 'back-up' ? null : session.safety}
        ready={jobs.ready.value}
        unticked={jobs.unticked.value}
        label={words.start[plan.kind]}
        onCancel={() => jobs.dismiss()}
        onStart={() => void jobs.start()}
      />
    </>
  );
}

/** The values that cannot be written, and why. Then nothing is. */
function Refusals({ session, changes }: { readonly session: Session; readonly changes: readonly MemoryChange[] }) {
  const { memories: words, about } = messages.value;
  const refused = changes.filter((change) => refusalsOf(change).length > 0);
  if (refused.length === 0) return null;
  return (
    <div class="notice bad" role="alert">
      {refused.map((change) => (
        <div key={change.memory}>
          <p>{words.refused(memoryText(session, change.memory))}</p>
          <ul>
            {refusalsOf(change).map((finding) => {
              const { identity } = change.goal;
              const { field } = finding;
              const what = field && words.figure(fieldName(identity, field), String(valueAt(change.goal, field)));
              return (
                <li key={what}>
                  {about(what ?? '')} {findingText(finding)}
                </li>
              );
            })}
          </ul>
        </div>
      ))}
    </div>
  );
}

interface MemoryDifferenceProps {
  readonly session: Session;
  readonly change: MemoryChange;
  readonly folded: boolean;
}

/** What changes in one memory: DT and motor stop first, then all values that differ. */
function MemoryDifference({ session, change: { memory, before, goal, changes }, folded }: MemoryDifferenceProps) {
  const { memories: words, edits } = messages.value;
  const held = keyFigures(before);
  const name = memoryText(session, memory);
  const figures = keyFigures(goal).map(({ label, text }, index) => {
    const was = held[index]?.text ?? text;
    return was === text ? words.stays(label, text) : edits.change(label, was, text);
  });
  const table = changes.length > 0 && <Difference before={before} goal={goal} changes={changes} />;
  return (
    <section aria-label={name}>
      <p>
        <strong>{words.figures(name, figures)}</strong>
      </p>
      {changes.length === 0 && <p>{words.same(name)}</p>}
      {folded && table ? (
        <details>
          <summary>{words.changes(changes.length)}</summary>
          {table}
        </details>
      ) : (
        table
      )}
    </section>
  );
}

function titleOf(plan: Plan): string {
  const { memories: words, memoryName } = messages.value;
  if (plan.kind === 'copy') return words.plans.copy.title(memoryName(plan.from), memoryName(plan.to));
  return words.plans[plan.kind].title;
}

/** What it does, and which memory flies next after it, if that is known. */
function leadOf(session: Session, plan: Plan): string {
  const { editor, nextFlight } = session;
  const current = nextFlight.open.value ? null : (editor.baseline.value?.memory ?? null);
  const does = doingOf(session, plan);
  return current === null ? does : `${does} ${messages.value.memories.atEnd(memoryText(session, current))}`;
}

function doingOf(session: Session, plan: Plan): string {
  const { memories: words } = messages.value;
  if (plan.kind === 'back-up') return words.plans['back-up'].lead;
  if (plan.kind === 'copy') return words.plans.copy.lead(memoryText(session, plan.from), memoryText(session, plan.to));
  const names = plan.backups.flatMap(({ program: { memory } }) =>
    memory === null ? [] : [memoryText(session, memory)],
  );
  return words.plans.restore.lead(names.join(', '), dateText(plan.backups[0]?.savedAt ?? 0));
}

function runningLabel(plan: Plan, progress: Progress | null): string {
  const { memories: words, write, memoryName } = messages.value;
  const memory = progress?.memory ?? null;
  const stage = progress ? write.stages[progress.stage] : titleOf(plan);
  return memory === null ? stage : words.stage(stage, memoryName(memory));
}

interface ResultProps {
  readonly session: Session;
  readonly jobs: MemoryJobs;
  readonly current: StepOf<'done'>;
}

function Result({ session, jobs, current }: ResultProps) {
  const { memories: words, write, notKept } = messages.value;
  const { plan, outcome, kept } = current;
  const { ends, saved, notHeld, stopped, strayed } = outcome;
  const again = notHeld || stopped === 'stale';
  return (
    <>
      <div class={`notice ${isGood(outcome) && kept ? 'good' : 'bad'}`} role="alert">
        {stopped && <NoticeText said={stoppedText(stopped)} />}
        {saved > 0 && <p>{words.saved(saved)}</p>}
        {ends.map((end) => (
          <p key={end.memory}>{endText(session, end)}</p>
        ))}
        {strayed !== null && <NoticeText said={write.strayed(memoryText(session, strayed))} />}
        {notHeld && <NoticeText said={write.move.notHeld} />}
        {!kept && <p>{notKept}</p>}
      </div>
      {plan.kind !== 'back-up' && <Current session={session} />}
      <ClosingButtons
        onClose={() => jobs.dismiss()}
        again={
          again
            ? {
                label: notHeld ? write.move.again : words.again,
                disabled: !session.runner.ready.value,
                onClick: () => void jobs.open(plan),
              }
            : null
        }
      />
    </>
  );
}

/** Which memory flies next after the job, as soon as that is known. */
function Current({ session }: { readonly session: Session }) {
  const { nextFlight } = messages.value;
  const { nextFlight: next, connection, runner, editor } = session;
  const memory = editor.baseline.value?.memory ?? null;
  const word = next.word.value;
  if (runner.busy.value) return null;
  const isKnown = connection.value && !next.open.value && memory !== null;
  const said = word
    ? nextFlightText(session, word, connection.value ? 'now' : 'last')
    : isKnown
      ? nextFlight.other(memoryText(session, memory))
      : nextFlight.unknown;
  return <p role="status">{said}</p>;
}

/** What one memory holds, as far as that is known. */
function endText(session: Session, { memory, state, known, change }: MemoryEnd): string {
  const { memories: words } = messages.value;
  const name = memoryText(session, memory);
  if (state === 'verified' && known.state === 'read') {
    const figures = keyFigures(known.program).map(({ label, text }) => words.figure(label, text));
    return words.verified(name, clockText(known.at), [...figures, words.changes(change?.changes.length ?? 0)]);
  }
  if (state !== 'unknown' || known.state !== 'uncertain') return words.ends[state](name);
  const open = openValues(known).map(({ field, from, to }) => {
    const [either, or] = [from, to].map((value) => figureText(known.before.identity, field, value ?? 0));
    return words.either(fieldInSentence(known.before.identity, field), either ?? '', or ?? '');
  });
  return words.uncertain(name, open.slice(0, SHOWN), open.length - SHOWN);
}

function stoppedText(stopped: NonNullable<MemoriesOutcome['stopped']>): Said {
  const { memories: words, timer, notes } = messages.value;
  if (stopped === 'unexpected') return notes.unexpected;
  return stopped === 'aborted' ? words.stopped : timer[stopped];
}
