import type { ComponentChildren } from 'preact';
import type { Progress } from '../../client/index.js';
import { fieldKey, type Model, valueAt } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { Editor } from '../editing/editor.js';
import { modelMessages } from '../messages/en-which-model.js';
import {
  clockText,
  dateText,
  fieldName,
  figureText,
  findingText,
  messages,
  type Said,
  timerSaid,
} from '../messages/index.js';
import { keyFields, keyFigures, keyName } from '../messages/key-figures.js';
import type { Crossing } from '../records/crossing.js';
import { Check } from '../ui/check.js';
import { Modal } from '../ui/modal.js';
import { NoticeText } from '../ui/notice-text.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import { ClosingButtons, JobStep } from './dialog-steps.js';
import { Difference } from './difference.js';
import {
  type Done,
  isGood,
  isOfScreen,
  type MemoriesPlan,
  type MemoryChange,
  type MemoryEnd,
  type Outcome,
  type Plan,
  type Review,
  refusalsOf,
} from './plan.js';
import { StartButtons } from './start-buttons.js';
import { UncertainNote } from './uncertain-note.js';
import { nextFlightText } from './unfinished-text.js';
import { ValueTable } from './value-table.js';
import type { WriteJob } from './write-job.js';
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
        <Result session={session} write={write} done={current}>
          {write.verified.value && !current.notHeld && after}
        </Result>
      )}
    </Modal>
  );
}

function titleOf(session: Session, plan: Plan): string {
  const { write, memories } = messages.value;
  if (isOfScreen(plan)) return write.title;
  if (plan.kind === 'copy') return memories.copy(memoryText(session, plan.from), memoryText(session, plan.to));
  return memories.restore;
}

/** “Reading M3”. */
function runningText(session: Session, plan: Plan, progress: Progress | null): string {
  const stage = progress ? messages.value.write.stages[progress.stage] : titleOf(session, plan);
  const memory = plan.kind === 'edits' ? null : (progress?.memory ?? null);
  return memory === null ? stage : `${stage} ${messages.value.memoryName(memory)}`;
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
            <span class="hint key-name">{isBad ? program.shortDt : keyName(identity, field)}</span>{' '}
            <strong>{figureText(identity, field, to)}</strong>{' '}
            <small>{from === to ? words.asItIs : words.insteadOf(figureText(identity, field, from))}</small>
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
      {isEdits && <Conflicts editor={session.editor} />}
      <Refusals session={session} changes={changes} />
      {crossing && <CrossingCheck crossing={crossing} write={write} />}
      {isOfScreen(plan) && <Serious write={write} identity={changes[0]?.goal.identity} />}
      {session.servoMoves.needed && all.some(({ field }) => field.kind === 'position') && (
        <MoveServosCheck servoMoves={session.servoMoves} />
      )}
      {isOfScreen(plan) && <WriteTo session={session} write={write} chosen={changes[0]?.memory ?? null} />}
      {(!isEdits || all.length > 0) && <p>{leadOf(session, review)}</p>}
      {changes.map((change) => (
        <MemoryDifference key={change.memory} session={session} change={change} folded={changes.length > 1} />
      ))}
      <StartButtons
        safety={session.safety}
        ready={write.ready.value}
        unticked={write.unticked.value}
        label={words.start(all.length)}
        onCancel={() => write.dismiss()}
        onStart={() => write.goOn()}
      />
    </>
  );
}

/** Asks whether to write values of one model into the timer of another, and names both. */
function CrossingCheck({ crossing, write }: Pick<ReviewProps, 'write'> & { readonly crossing: Crossing }) {
  const { crossing: words } = modelMessages;
  const [from, to] = [crossing.from.name, crossing.to.map(({ name }) => name)];
  return (
    <div class="notice bad" role="alert">
      <NoticeText said={{ title: words.title(from, to), advice: words.advice }} />
      <Check checked={write.ticked.value.has('model')} onChange={(checked) => write.tick('model', checked)}>
        {words.confirm(from, to)}
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
            {finding.field && identity && <strong>{about(fieldName(identity, finding.field))} </strong>}
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
  const refused = changes.filter((change) => refusalsOf(change).length > 0);
  if (refused.length === 0) return null;
  return (
    <div class="notice bad" role="alert">
      {refused.map((change) => (
        <div key={change.memory}>
          <p>{words.refused(whereText(session, change.memory, null))}</p>
          <ul>
            {refusalsOf(change).map((finding) => {
              const { field } = finding;
              const what = field ? `${fieldName(change.goal.identity, field)} ${valueAt(change.goal, field)}` : '';
              return (
                <li key={what}>
                  {about(what)} {findingText(finding)}
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
  if (plan.kind === 'edits') return write.lead(whereText(session, changes[0]?.memory ?? null, model));
  const { editor, nextFlight } = session;
  const current = nextFlight.open.value ? null : (editor.baseline.value?.memory ?? null);
  const does = doesOf(session, plan, changes, model);
  return current === null ? does : `${does} ${words.atEnd(memoryText(session, current))}`;
}

function doesOf(session: Session, plan: MemoriesPlan, changes: Review['changes'], model: Model | null): string {
  const { plans } = messages.value.memories;
  if (plan.kind === 'copy') return plans.copy(memoryText(session, plan.from), memoryText(session, plan.to));
  if (plan.kind === 'screen') {
    const { idleThrottle } = plan.program;
    const isLeft = idleThrottle !== null && idleThrottle !== changes[0]?.before.idleThrottle;
    return plans.screen(whereText(session, plan.to, model), isLeft);
  }
  const names = changes.map(({ memory }) => whereText(session, memory, null));
  return plans.restore(names.join(', '), dateText(plan.backups[0]?.savedAt ?? 0));
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
          <summary>{program.changes(changes.length)}</summary>
          {table}
        </details>
      )}
    </section>
  );
}

interface ResultProps extends Pick<WriteDialogProps, 'session' | 'write'> {
  readonly done: Done;
  readonly children: ComponentChildren;
}

function Result({ session, write, done, children }: ResultProps) {
  const { write: words, knowledge } = messages.value;
  const { plan, ends, notHeld, stopped, strayed } = done;
  const isEdits = plan.kind === 'edits';
  const canWrite = session.runner.ready.value && !(isEdits && session.editor.blocked.value);
  const unknown = isEdits ? words.unknown : { ...words.unknown, advice: knowledge.noFly };
  const has = (wanted: MemoryEnd['state']): boolean => ends.some(({ state }) => state === wanted);
  return (
    <>
      <div class={`notice ${isGood(done) ? 'good' : 'bad'}`} role="alert">
        {isGood(done) && <NoticeText said={words.verified} />}
        {has('unknown') && <NoticeText said={unknown} />}
        {has('differs') && <NoticeText said={words.differs} />}
        {ends.map((end) => (
          <EndLine key={end.memory} session={session} done={done} end={end} />
        ))}
        {stopped && <NoticeText said={stoppedText(stopped)} />}
        {strayed !== null && <NoticeText said={words.strayed(memoryText(session, strayed))} />}
        {notHeld && <NoticeText said={words.move.notHeld} />}
      </div>
      {ends.map((end) => (
        <EndTable key={end.memory} session={session} end={end} isOnly={ends.length === 1} />
      ))}
      {!isEdits && <Current session={session} />}
      {children}
      <ClosingButtons
        onClose={() => write.dismiss()}
        again={
          notHeld || stopped?.code === 'stale'
            ? { label: words.move.again, disabled: !canWrite, onClick: () => write.goOn() }
            : null
        }
      />
    </>
  );
}

/** What a reading of a memory has shown, in one line. What is not known stands at the top. */
function EndLine({ session, done: { at, model }, end }: Pick<ResultProps, 'session' | 'done'> & { end: MemoryEnd }) {
  const { write: words, memories } = messages.value;
  const { memory, state, change, report } = end;
  const where = whereText(session, memory, model);
  if (state === 'untouched') return <p>{memories.untouched(where)}</p>;
  const held = report?.held;
  if (state !== 'verified' || !held) return null;
  const figures = keyFigures(held).map(({ label, text }) => `${label} ${text}`);
  return (
    <p>
      <strong>{words.verdict(where, clockText(at), figures, change?.changes.length ?? 0)}</strong>
    </p>
  );
}

/** The values that the timer did not take, or took although nobody asked. */
function EndTable({ session, end, isOnly }: Pick<ResultProps, 'session'> & { end: MemoryEnd; isOnly: boolean }) {
  const { report, change, memory } = end;
  const { write: words } = messages.value;
  const shown = report?.values.filter(({ status, asked }) => status !== 'verified' || !asked) ?? [];
  if (!change || shown.length === 0) return null;
  return (
    <>
      {!isOnly && <h3>{whereText(session, memory, null)}</h3>}
      <ValueTable
        identity={change.goal.identity}
        names={[words.wanted, words.readBack]}
        rows={shown.map(({ field, wanted, held, status }) => ({
          field,
          values: [wanted, held],
          // An unknown value has its own text already.
          note: { unknown: null, differs: words.status.differs, verified: words.putBack }[status],
        }))}
        lastCounts
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

/** “M1 “calm” of Lancer 07”, as far as it is known. */
function whereText(session: Session, memory: number | null, model: Model | null): string {
  const name = memory === null ? messages.value.knowledge.thisMemory : memoryText(session, memory);
  return model ? modelMessages.crossing.memoryOf(name, model.name) : name;
}

function stoppedText({ code, details }: NonNullable<Outcome['stopped']>): Said {
  const { memories, timer, notes } = messages.value;
  if (code === 'unexpected') return notes.unexpected;
  return code === 'aborted' ? { ...timer.aborted, advice: memories.stopped } : timerSaid({ code, details });
}
