import type { ComponentChildren } from 'preact';
import { clockText, messages, type Said, timerSaid } from '../messages/index.js';
import { keyFigures } from '../messages/key-figures.js';
import { NoticeText } from '../ui/notice-text.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import { ClosingButtons } from './dialog-steps.js';
import { type Done, isGood, type MemoryEnd, type Outcome } from './plan.js';
import { nextFlightText } from './unfinished-text.js';
import { ValueTable } from './value-table.js';
import { whereText } from './where-text.js';
import type { WriteJob } from './write-job.js';

interface ResultProps {
  readonly session: Session;
  readonly write: WriteJob;
  readonly done: Done;
  readonly children: ComponentChildren;
}

/** The last step: what became of each memory that was to be written. */
export function WriteResult({ session, write, done, children }: ResultProps) {
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

function stoppedText({ code, details }: NonNullable<Outcome['stopped']>): Said {
  const { memories, timer, notes } = messages.value;
  if (code === 'unexpected') return notes.unexpected;
  return code === 'aborted' ? { ...timer.aborted, advice: memories.stopped } : timerSaid({ code, details });
}
