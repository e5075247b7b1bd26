import type { ComponentChildren } from 'preact';
import type { TimerError } from '../../client/index.js';
import { fieldKey, type Model, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { Editor } from '../editing/editor.js';
import { modelMessages } from '../messages/en-which-model.js';
import { clockText, fieldName, figureText, findingText, messages, timerSaid } from '../messages/index.js';
import { keyFields, keyName } from '../messages/key-figures.js';
import { memoryText } from '../session/memory-names.js';
import type { Session } from '../session/session.js';
import { Check } from '../ui/check.js';
import { Modal } from '../ui/modal.js';
import { NoticeText } from '../ui/notice-text.js';
import { CrossingCheck } from './crossing-check.js';
import { ClosingButtons, JobStep } from './dialog-steps.js';
import { Difference } from './difference.js';
import { MoveServosCheck } from './move-servos-check.js';
import { StartButtons } from './start-buttons.js';
import { strayed } from './strayed.js';
import { UncertainNote } from './uncertain-note.js';
import { ValueTable } from './value-table.js';
import type { Shown, WriteFlow, WriteStep } from './write-flow.js';
import './write-dialog.css';

interface WriteDialogProps {
  readonly session: Session;
  readonly write: WriteFlow;
  /** Further buttons after a verified write. */
  readonly after: ComponentChildren;
}

/** One dialog for the whole write: difference, progress, result. */
export function WriteDialog({ session, write, after }: WriteDialogProps) {
  const current = write.current.value;
  const identity = current && session.editor.identity.value;
  const { write: words } = messages.value;
  return (
    <Modal
      open={current !== null && identity !== null}
      title={words.title}
      head={
        <>
          <UncertainNote session={session} />
          {current?.step === 'review' && <KeyFigures shown={current.shown} isShort={write.short.value} />}
        </>
      }
      held={write.held}
      onEscape={() => write.dismiss()}
    >
      {current && identity && (
        <>
          {current.step === 'review' && <Review session={session} write={write} review={current} />}
          {current.step === 'running' && (
            <JobStep
              runner={session.runner}
              label={(progress) => (progress ? words.stages[progress.stage] : words.title)}
              onStop={() => write.dismiss()}
            />
          )}
          {current.step === 'done' && (
            <Result session={session} write={write} identity={identity} done={current}>
              {current.report.result === 'verified' && !current.notHeld && after}
            </Result>
          )}
          {current.step === 'refused' && <Refused write={write} error={current.error} />}
        </>
      )}
    </Modal>
  );
}

/** “3:00 min”, or that the value is not known. */
function figure(identity: Identity, field: ProgramField, value: number | null): string {
  return value === null ? messages.value.write.status.unknown : figureText(identity, field, value);
}

/** DT and motor stop, whatever else is written: a pilot looks at them first. A short DT is red. */
function KeyFigures({ shown: { baseline, goal }, isShort }: { readonly shown: Shown; readonly isShort: boolean }) {
  const { write: words, program } = messages.value;
  return (
    <p class="key-figures">
      {keyFields(goal.identity).map((field, at) => {
        const [from, to] = [valueAt(baseline, field), valueAt(goal, field)];
        // DT comes first.
        const isBad = at === 0 && isShort;
        return (
          <span key={fieldKey(field)} class={isBad ? 'bad-text' : undefined}>
            <span class="key-name">{isBad ? program.shortDt : keyName(goal.identity, field)}</span>{' '}
            <strong>{figure(goal.identity, field, to)}</strong>{' '}
            <small>{from === to ? words.asItIs : words.insteadOf(figure(goal.identity, field, from))}</small>
          </span>
        );
      })}
    </p>
  );
}

interface ReviewProps {
  readonly session: Session;
  readonly write: WriteFlow;
  readonly review: Extract<WriteStep, { step: 'review' }>;
}

function Review({ session, write, review: { shown, moved } }: ReviewProps) {
  const { write: words, timer, about } = messages.value;
  const { changes } = shown;
  const { identity, memory } = shown.goal;
  const serious = write.serious.value;
  return (
    <>
      {moved && (
        <div class="notice bad" role="alert">
          <NoticeText said={{ ...timer.stale, ...(moved === 'timer' ? {} : words.moved[moved]) }} />
        </div>
      )}
      <Conflicts editor={session.editor} identity={identity} />
      <CrossingCheck
        crossing={shown.crossing}
        acknowledged={write.crossed.value}
        onAcknowledge={(wanted) => write.cross(wanted)}
      />
      {serious.length > 0 && (
        <div class="notice bad">
          <ul>
            {serious.map((finding) => (
              <li key={`${finding.field ? fieldKey(finding.field) : ''} ${finding.code}`}>
                {finding.field && <strong>{about(fieldName(identity, finding.field))} </strong>}
                {findingText(finding)}
              </li>
            ))}
          </ul>
          <Check checked={write.acknowledged.value} onChange={(checked) => write.acknowledge(checked)}>
            {words.acknowledge}
          </Check>
        </div>
      )}
      {changes.some(({ field }) => field.kind === 'position') && <MoveServosCheck servoMoves={session.servoMoves} />}
      <p>{changes.length === 0 ? words.nothing : words.lead(whereText(session, memory, shown.model))}</p>
      {changes.length > 0 && <Difference before={shown.baseline} goal={shown.goal} changes={changes} />}
      <StartButtons
        safety={session.safety}
        ready={write.ready.value}
        unticked={write.unticked.value}
        label={words.start(changes.length)}
        onCancel={() => write.dismiss()}
        onStart={() => void write.start()}
      />
    </>
  );
}

/** Values that have changed in the timer since the edits were made. What is about to be written stands below. */
function Conflicts({ editor, identity }: { readonly editor: Editor; readonly identity: Identity }) {
  const { write, notes } = messages.value;
  const changes = [...editor.conflicts.value.values()];
  if (changes.length === 0) return null;
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

type Done = Extract<WriteStep, { step: 'done' }>;

interface ResultProps {
  readonly session: Session;
  readonly write: WriteFlow;
  readonly identity: Identity;
  readonly done: Done;
  readonly children: ComponentChildren;
}

function Result({ session, write, identity, done, children }: ResultProps) {
  const { report, notHeld } = done;
  const { write: words } = messages.value;
  const canWrite = session.runner.ready.value && !session.editor.blocked.value;
  const other = strayed([report]);
  const shown = report.values.filter(({ status, asked }) => status !== 'verified' || !asked);
  return (
    <>
      <div class={`notice ${report.result === 'verified' ? 'good' : 'bad'}`} role="alert">
        <NoticeText said={words[report.result]} />
        {report.result === 'verified' && report.held && <Verdict session={session} done={done} held={report.held} />}
        {report.stopped && <NoticeText said={timerSaid(report.stopped)} />}
        {other !== null && <NoticeText said={words.strayed(memoryText(session, other))} />}
        {notHeld && <NoticeText said={words.move.notHeld} />}
      </div>
      {shown.length > 0 && (
        <ValueTable
          identity={identity}
          names={[words.wanted, words.readBack]}
          rows={shown.map(({ field, wanted, held, status, asked }) => ({
            field,
            values: [wanted, held],
            // An unknown value has its own text already.
            note: status === 'unknown' ? null : asked || status !== 'verified' ? words.status[status] : words.putBack,
          }))}
          lastCounts
        />
      )}
      {children}
      <ClosingButtons
        onClose={() => write.dismiss()}
        again={notHeld ? { label: words.move.again, disabled: !canWrite, onClick: () => void write.again() } : null}
      />
    </>
  );
}

interface VerdictProps {
  readonly session: Session;
  readonly done: Done;
  readonly held: TimerProgram;
}

/** What a reading of the timer has shown, in one line. */
function Verdict({ session, done: { at, shown }, held }: VerdictProps) {
  const { write: words } = messages.value;
  const { identity, memory } = held;
  const figures = keyFields(identity).map(
    (field) => `${keyName(identity, field)} ${figure(identity, field, valueAt(held, field))}`,
  );
  const where = whereText(session, memory, shown.model);
  return (
    <p>
      <strong>{words.verdict(where, clockText(at), figures, shown.changes.length)}</strong>
    </p>
  );
}

/** “M1 “calm” of Lancer 07”, as far as it is known. */
function whereText(session: Session, memory: number | null, model: Model | null): string {
  const name = memory === null ? messages.value.knowledge.thisMemory : memoryText(session, memory);
  return model ? modelMessages.crossing.memoryOf(name, model.name) : name;
}

interface RefusedProps {
  readonly write: WriteFlow;
  readonly error: TimerError;
}

function Refused({ write, error }: RefusedProps) {
  const { write: words } = messages.value;
  return (
    <>
      <div class="notice bad" role="alert">
        <p>
          <strong>{words.refused}</strong>
        </p>
        <NoticeText said={timerSaid(error)} />
      </div>
      <ClosingButtons onClose={() => write.dismiss()} />
    </>
  );
}
