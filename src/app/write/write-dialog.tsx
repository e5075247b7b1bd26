import type { ComponentChildren } from 'preact';
import type { Progress } from '../../client/index.js';
import { fieldKey, type Model, valueAt } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { Editor } from '../editing/editor.js';
import { eitherOf } from '../messages/either.js';
import { dateText, fieldInSentence, fieldName, figureText, findingText, messages } from '../messages/index.js';
import { keyFields } from '../messages/key-figures.js';
import { moreMessages } from '../messages/more.js';
import { memoryName } from '../messages/names.js';
import type { Crossing } from '../records/crossing.js';
import { Check } from '../ui/check.js';
import { Modal } from '../ui/modal.js';
import { NoticeText } from '../ui/notice-text.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import { JobStep } from './dialog-steps.js';
import { Difference } from './difference.js';
import { isOfScreen, isOwn, isPart, type MemoriesPlan, type MemoryChange, type Plan, type Review } from './plan.js';
import { StartButtons } from './start-buttons.js';
import { UncertainNote } from './uncertain-note.js';
import { ValueTable } from './value-table.js';
import { whereText } from './where-text.js';
import type { WriteJob } from './write-job.js';
import { WriteResult } from './write-result.js';
import { WriteTo } from './write-to.js';
import './write-dialog.css';

interface WriteDialogProps {
  readonly session: Session;
  readonly write: WriteJob;
  /** Further buttons after a verified write of what is on the screen. */
  readonly after: ComponentChildren;
}

/** One dialog for everything that changes what memories hold: difference, progress, result. */
export function WriteDialog({ session, write, after }: WriteDialogProps) {
  const current = write.current.value;
  const only = current?.step === 'review' && current.changes.length === 1 ? current.changes[0] : null;
  return (
    <Modal
      open={current !== null}
      title={current ? titleOf(session, current.plan) : ''}
      head={
        <>
          <UncertainNote session={session} />
          {only && <KeyFigures session={session} change={only} />}
        </>
      }
      held={write.held}
      onEscape={() => write.dismiss()}
    >
      {current?.step === 'review' && <ReviewStep session={session} write={write} review={current} />}
      {current?.step === 'running' && (
        <JobStep
          runner={session.runner}
          label={(progress) => runningText(session, current.plan, progress)}
          onStop={() => write.dismiss()}
        />
      )}
      {current?.step === 'done' && (
        <WriteResult session={session} write={write} done={current}>
          {write.verified.value && !current.notHeld && after}
        </WriteResult>
      )}
    </Modal>
  );
}

function titleOf(session: Session, plan: Plan): string {
  const { write, memories } = messages.value;
  if (isOfScreen(plan)) return write.title;
  if (plan.kind === 'copy')
    return memories.copy({ from: memoryText(session, plan.from), to: memoryText(session, plan.to) });
  return memories.restore;
}

/** “Reading M3”. */
function runningText(session: Session, plan: Plan, progress: Progress | null): string {
  const stage = progress ? messages.value.write.stages[progress.stage] : titleOf(session, plan);
  const memory = plan.kind === 'edits' ? null : (progress?.memory ?? null);
  return memory === null ? stage : `${stage} ${memoryName(memory)}`;
}

interface ChangeProps extends Pick<WriteDialogProps, 'session'> {
  readonly change: MemoryChange;
}

/** DT and motor stop, whatever else is written: a pilot looks at them first. A short DT is red. */
function KeyFigures({ session, change }: ChangeProps) {
  const { write: words, program } = messages.value;
  const { before } = change;
  const { identity } = before;
  // A goal without an idle throttle leaves it as it is.
  const goal = { ...change.goal, idleThrottle: change.goal.idleThrottle ?? before.idleThrottle };
  return (
    <p class="row key-figures">
      {keyFields(identity).map((field, at) => {
        const [from, to] = [valueAt(before, field), valueAt(goal, field)];
        // DT comes first.
        const isBad = at === 0 && session.shortDt.isShort(goal);
        return (
          <span key={fieldKey(field)} class={isBad ? 'bad-text' : undefined}>
            <span class="hint sentence key-name">{isBad ? program.shortDt : fieldInSentence(identity, field)}</span>{' '}
            <strong>{figureText(identity, field, to)}</strong>{' '}
            <small>{from === to ? words.asItIs : words.insteadOf({ value: figureText(identity, field, from) })}</small>
          </span>
        );
      })}
    </p>
  );
}

interface ReviewProps extends Pick<WriteDialogProps, 'session' | 'write'> {
  readonly review: Review;
}

function ReviewStep({ session, write, review }: ReviewProps) {
  const { write: words, timer } = messages.value;
  const { changes, moved, plan, crossing } = review;
  const isEdits = plan.kind === 'edits';
  const all = changes.flatMap((change) => change.changes);
  return (
    <>
      {moved && (
        <div class="notice bad" role="alert">
          <NoticeText said={{ ...timer.stale, ...(moved === 'timer' ? {} : words.moved[moved]) }} />
        </div>
      )}
      {isOwn(plan) && !isPart(plan) && <Conflicts editor={session.editor} />}
      <Refusals session={session} changes={changes} />
      {crossing && <CrossingCheck crossing={crossing} write={write} />}
      {isOfScreen(plan) && <Serious write={write} identity={changes[0]?.goal.identity} />}
      {session.servoMoves.needed && all.some(({ field }) => field.kind === 'position') && (
        <MoveServosCheck servoMoves={session.servoMoves} />
      )}
      {isOfScreen(plan) && !isPart(plan) && (
        <WriteTo session={session} write={write} chosen={changes[0]?.memory ?? null} />
      )}
      {(!isEdits || all.length > 0) && <p>{leadOf(session, review)}</p>}
      {changes.map((change) => (
        <MemoryDifference key={change.memory} session={session} change={change} folded={changes.length > 1} />
      ))}
      <StartButtons
        safety={session.safety}
        ready={write.ready.value}
        unticked={write.unticked.value}
        label={words.start({ count: all.length })}
        onCancel={() => write.dismiss()}
        onStart={() => write.goOn()}
      />
    </>
  );
}

/** Asks whether to write values of one model into the timer of another, and names both. */
function CrossingCheck({ crossing, write }: Pick<ReviewProps, 'write'> & { readonly crossing: Crossing }) {
  const { crossing: words } = moreMessages.value.whichModel;
  const [from, to] = [crossing.from.name, eitherOf(crossing.to.map(({ name }) => name))];
  return (
    <div class="notice bad" role="alert">
      <NoticeText said={{ title: words.title({ from, to }), advice: words.advice }} />
      <Check checked={write.ticked.value.has('model')} onChange={(checked) => write.tick('model', checked)}>
        {words.confirm({ from, to })}
      </Check>
    </div>
  );
}

/** Asks whether a write may move the servos. Only for a timer that keeps positions where the servos stand. */
function MoveServosCheck({ servoMoves }: Pick<Session, 'servoMoves'>) {
  const { move } = messages.value.write;
  return (
    <div class="notice">
      <p>{move.why}</p>
      <Check checked={servoMoves.allowed.value} onChange={(checked) => servoMoves.allow(checked)}>
        {/* In the label: what follows the box may lie behind the buttons when it is ticked. */}
        <span>
          {move.label} <strong>{move.hint}</strong>
        </span>
      </Check>
    </div>
  );
}

/** The serious findings, which the pilot has to read before they are written. */
function Serious({ write, identity }: { readonly write: WriteJob; readonly identity: Identity | undefined }) {
  const { write: words, about } = messages.value;
  const serious = write.serious.value;
  if (serious.length === 0) return null;
  return (
    <div class="notice bad">
      <ul>
        {serious.map((finding) => (
          <li key={`${finding.field ? fieldKey(finding.field) : ''} ${finding.code}`}>
            {finding.field && identity && <strong>{about({ name: fieldName(identity, finding.field) })} </strong>}
            {findingText(finding)}
          </li>
        ))}
      </ul>
      <Check checked={write.ticked.value.has('warnings')} onChange={(checked) => write.tick('warnings', checked)}>
        {words.acknowledge}
      </Check>
    </div>
  );
}

/** The values that cannot be written, and why. Then nothing is. */
function Refusals({ session, changes }: { readonly session: Session; readonly changes: readonly MemoryChange[] }) {
  const { memories: words, about } = messages.value;
  const refused = changes.filter(({ refusals }) => refusals.length > 0);
  if (refused.length === 0) return null;
  return (
    <div class="notice bad" role="alert">
      {refused.map(({ memory, goal, refusals }) => (
        <div key={memory}>
          <p>{words.refused({ memory: whereText(session, memory, null) })}</p>
          <ul>
            {refusals.map((finding) => {
              const { field } = finding;
              const what = field ? `${fieldName(goal.identity, field)} ${valueAt(goal, field)}` : '';
              return (
                <li key={what}>
                  {about({ name: what })} {findingText(finding)}
                </li>
              );
            })}
          </ul>
        </div>
      ))}
    </div>
  );
}

/** Values that have changed in the timer since the edits were made. What is about to be written stands below. */
function Conflicts({ editor }: { readonly editor: Editor }) {
  const { write, notes } = messages.value;
  const identity = editor.identity.value;
  const changes = [...editor.conflicts.value.values()];
  if (!identity || changes.length === 0) return null;
  return (
    <div class="notice bad">
      <NoticeText said={notes.moved} />
      <ValueTable
        identity={identity}
        names={[write.wasRead, write.from]}
        rows={changes.map(({ field, from, to }) => ({ field, values: [from, to] }))}
        lastCounts
      />
    </div>
  );
}

/** What is written where, and which memory flies next after it, if that is known. */
function leadOf(session: Session, { plan, changes, model }: Review): string {
  const { write, memories: words } = messages.value;
  if (plan.kind === 'edits') return write.lead({ memory: whereText(session, changes[0]?.memory ?? null, model) });
  const current = session.nextFlight.memory.value;
  const does = doesOf(session, plan, changes, model);
  return current === null ? does : `${does} ${words.atEnd({ current: memoryText(session, current) })}`;
}

function doesOf(session: Session, plan: MemoriesPlan, changes: Review['changes'], model: Model | null): string {
  const { plans } = messages.value.memories;
  if (plan.kind === 'copy')
    return plans.copy({ from: memoryText(session, plan.from), to: memoryText(session, plan.to) });
  if (plan.kind === 'screen') {
    const idleThrottle = session.editor.working.value?.idleThrottle ?? null;
    const isLeft = idleThrottle !== null && idleThrottle !== changes[0]?.before.idleThrottle;
    return plans.screen({ to: whereText(session, plan.to, model), keepsThrottle: isLeft });
  }
  const names = changes.map(({ memory }) => whereText(session, memory, null));
  return plans.restore({ names: names.join(', '), time: dateText(plan.backups[0]?.savedAt ?? 0) });
}

/** @param folded whether it is one of several: then DT and motor stop stand here, and the rest is folded away. */
function MemoryDifference({ session, change, folded }: ChangeProps & { readonly folded: boolean }) {
  const { write: words, program } = messages.value;
  const { before, goal, changes } = change;
  const table =
    changes.length > 0 ? <Difference before={before} goal={goal} changes={changes} /> : <p>{words.nothing}</p>;
  if (!folded) return table;
  const name = whereText(session, change.memory, null);
  return (
    <section class="stack" aria-label={name}>
      <h3>{name}</h3>
      <KeyFigures session={session} change={change} />
      {changes.length === 0 ? (
        table
      ) : (
        <details>
          <summary>{program.changes({ count: changes.length })}</summary>
          {table}
        </details>
      )}
    </section>
  );
}
