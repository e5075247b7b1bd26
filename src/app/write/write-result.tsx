import type { ComponentChildren } from 'preact';
import { type PartOfWrite, partWritten, sameKind } from '../../program/index.js';
import { dotted } from '../messages/dotted.js';
import { clockText, messages, type Said, timerSaid } from '../messages/index.js';
import { keyFigures } from '../messages/key-figures.js';
import { NoticeText } from '../ui/notice-text.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import { ClosingButtons } from './dialog-steps.js';
import { type Done, isGood, type MemoryEnd, type Outcome } from './plan.js';
import { extentText, nextFlightText } from './unfinished-text.js';
import { ValueTable } from './value-table.js';
import { whereText } from './where-text.js';
import type { WriteJob } from './write-job.js';

interface ResultProps {
  readonly session: Session;
  readonly write: WriteJob;
  readonly done: Done;
  readonly children: ComponentChildren;
}

/** What stopped a write because no timer was there. It no longer holds once one is there again. */
const AWAY: ReadonlySet<string> = new Set(['port-lost', 'no-answer', 'closed']);

/** The last step: what became of each memory that was to be written, by what is known of it now. */
export function WriteResult({ session, write, done, children }: ResultProps) {
  const { write: words, knowledge } = messages.value;
  const { plan, notHeld, strayed } = done;
  const isEdits = plan.kind === 'edits';
  const canWrite = session.runner.ready.value && !(isEdits && session.editor.blocked.value);
  const unknown = isEdits ? words.unknown : { ...words.unknown, advice: knowledge.noFly };
  const ends = done.ends.map((end) => ({ ...end, found: foundIn(session, end) }));
  const stopped = session.connection.value && AWAY.has(done.stopped?.code ?? '') ? null : done.stopped;
  const isAgain = notHeld || stopped?.code === 'stale' || ends.some(({ found }) => found && found.missing.length > 0);
  const isIn = stopped === null && ends.every(({ state, found }) => state === 'verified' || found?.extent === 'all');
  return (
    <>
      <div class={`notice ${isIn ? 'good' : 'bad'}`} role="alert">
        {isGood(done) && <NoticeText said={words.verified} />}
        {ends.some(({ state, found }) => state === 'unknown' && !found) && <NoticeText said={unknown} />}
        {ends.some(({ state }) => state === 'differs') && <NoticeText said={words.differs} />}
        {ends.map((end) => (
          <EndLine key={end.memory} session={session} done={done} end={end} />
        ))}
        {stopped && <NoticeText said={stoppedText(stopped)} />}
        {strayed !== null && <Strayed memory={memoryText(session, strayed)} />}
        {notHeld && <NoticeText said={words.move.notHeld} />}
      </div>
      {ends.map((end) => (
        <EndTable key={end.memory} session={session} end={end} isOnly={ends.length === 1} />
      ))}
      {!isEdits && <Current session={session} />}
      {children}
      <ClosingButtons
        onClose={() => write.dismiss()}
        again={isAgain ? { label: words.move.again, disabled: !canWrite, onClick: () => write.goOn() } : null}
      />
    </>
  );
}

/** What became of a memory. `found`: what a reading after the end has shown, where the write left it open. */
interface FoundEnd extends MemoryEnd {
  readonly found: PartOfWrite | null;
}

function foundIn({ standings }: Session, { memory, state, change, report }: MemoryEnd): PartOfWrite | null {
  const { known } = standings.of(memory);
  if (state !== 'unknown' || !change || known.state !== 'read' || known.program === report?.held) return null;
  // Another timer may be there.
  if (!sameKind(known.program.identity, change.goal.identity)) return null;
  const part = partWritten(change.before, change.goal, known.program);
  return part.extent === 'foreign' ? null : part;
}

interface EndProps extends Pick<ResultProps, 'session'> {
  readonly end: FoundEnd;
}

function Strayed({ memory }: { readonly memory: string }) {
  const { title, advice } = messages.value.write.strayed;
  return <NoticeText said={{ title: title({ memory }), advice: advice({ memory }) }} />;
}

/** What a reading of a memory has shown. What is not known stands at the top. */
function EndLine({ session, done: { at, model }, end }: EndProps & Pick<ResultProps, 'done'>) {
  const { write: words, memories, program } = messages.value;
  const { memory, state, change, report, found } = end;
  const where = whereText(session, memory, model);
  if (state === 'untouched') return <p>{memories.untouched({ memory: where })}</p>;
  if (found) return <NoticeText said={{ title: words.cut({ memory: where }), advice: extentText(found) }} />;
  const held = report?.held;
  if (state !== 'verified' || !held) return null;
  const figures = keyFigures(held).map(({ label, text }) => `${label} ${text}`);
  return (
    <p>
      <strong>
        {dotted([
          words.verdict({ memory: where, time: clockText(at) }),
          ...figures,
          program.changes({ count: change?.changes.length ?? 0 }),
        ])}
      </strong>
    </p>
  );
}

/** The values that the timer did not take, or took although nobody asked. */
function EndTable({ session, end, isOnly }: EndProps & { readonly isOnly: boolean }) {
  const { report, change, memory, found } = end;
  const { write: words } = messages.value;
  const told = report?.values.filter(({ status, asked }) => status !== 'verified' || !asked) ?? [];
  const rows = found
    ? found.missing.map(({ field, from, to }) => ({ field, values: [to, from], note: words.status.differs }))
    : told.map(({ field, wanted, held, status }) => ({
        field,
        values: [wanted, held],
        // An unknown value has its own text already.
        note: { unknown: null, differs: words.status.differs, verified: words.putBack }[status],
      }));
  if (!change || rows.length === 0) return null;
  return (
    <>
      {!isOnly && <h3>{whereText(session, memory, null)}</h3>}
      <ValueTable identity={change.goal.identity} names={[words.wanted, words.readBack]} rows={rows} lastCounts />
    </>
  );
}

/** Which memory flies next after the job, as soon as that is known. */
function Current({ session }: { readonly session: Session }) {
  const { nextFlight } = messages.value;
  const { nextFlight: next, connection, runner } = session;
  const memory = next.memory.value;
  const word = next.word.value;
  if (runner.busy.value) return null;
  const isKnown = connection.value && memory !== null;
  const said = word
    ? nextFlightText(session, word, connection.value ? 'now' : 'last')
    : isKnown
      ? nextFlight.other({ memory: memoryText(session, memory) })
      : nextFlight.unknown;
  return <p role="status">{said}</p>;
}

function stoppedText({ code, details }: NonNullable<Outcome['stopped']>): Said {
  const { memories, timer, notes } = messages.value;
  if (code === 'unexpected') return notes.unexpected;
  return code === 'aborted' ? { ...timer.aborted, advice: memories.stopped } : timerSaid({ code, details });
}
