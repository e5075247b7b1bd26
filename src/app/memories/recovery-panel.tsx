import { type TimerProgram, valueAt } from '../../program/index.js';
import { dateText, messages } from '../messages/index.js';
import type { InterruptedJobs, Offer } from '../session/interrupted-jobs.js';
import { memoryOf } from '../session/memory-names.js';
import type { Session } from '../session/session.js';
import { interruptedText } from '../write/unfinished-text.js';
import { ValueTable } from '../write/value-table.js';
import type { WriteJob } from '../write/write-job.js';
import { finishWrite, takeGoal } from './finish-write.js';
import './recovery-panel.css';

interface RecoveryProps {
  readonly session: Session;
  readonly write: WriteJob;
  readonly offer: Offer;
}

/** What an earlier job left behind on a timer of this kind, and what can be done about it. */
export function Recovery({ session, write, offer }: RecoveryProps) {
  return (
    <section class="recovery" aria-labelledby="recovery-title">
      {offer.kind === 'write' && <InterruptedWrite session={session} write={write} offer={offer} />}
      {offer.kind === 'elsewhere' && <WriteElsewhere session={session} offer={offer} />}
      {offer.kind === 'memories' && <MemoryLeft session={session} offer={offer} />}
    </section>
  );
}

type OfferOf<Kind extends Offer['kind']> = Extract<Offer, { kind: Kind }>;

interface InterruptedWriteProps extends RecoveryProps {
  readonly offer: OfferOf<'write'>;
}

function InterruptedWrite({ session, write: flow, offer: { record, part, read } }: InterruptedWriteProps) {
  const { recovery: words, write } = messages.value;
  const busy = !session.runner.ready.value;
  const isForeign = part.extent === 'foreign';
  const said = {
    nothing: words.nothing(part.missing.length),
    part: words.part(part.written.length, part.missing.length),
    foreign: words.foreign(part.foreign.length),
    all: '',
  }[part.extent];
  return (
    <>
      <h2 id="recovery-title">{words.title}</h2>
      <p>
        {words.when(memoryOf(null, record.goal.memory), dateText(record.startedAt))} {said}
      </p>
      <details>
        <summary>{words.compare}</summary>
        <ValueTable
          identity={read.identity}
          names={[words.before, write.wanted, write.from]}
          rows={rows(record, part, read)}
          lastCounts
        />
      </details>
      {!isForeign && <p class="hint">{words.sure}</p>}
      <div class="buttons">
        {isForeign ? (
          <>
            <button type="button" onClick={() => session.recovery.setAside()}>
              {words.otherTimer}
            </button>
            <button type="button" disabled={busy} onClick={() => void takeGoal(session)}>
              {words.sameTimer}
            </button>
          </>
        ) : (
          <>
            <button
              type="button"
              class="primary"
              disabled={busy}
              onClick={() => void finishWrite(session, flow, 'goal')}
            >
              {words.finish}
            </button>
            {part.extent === 'part' && (
              <button type="button" disabled={busy} onClick={() => void finishWrite(session, flow, 'before')}>
                {words.goBack}
              </button>
            )}
            <button type="button" onClick={() => session.recovery.setAside()}>
              {words.otherTimer}
            </button>
          </>
        )}
        <button type="button" class="quiet" onClick={() => void session.recovery.settle()}>
          {words.leave}
        </button>
      </div>
    </>
  );
}

function WriteElsewhere({
  session,
  offer: { memory },
}: {
  readonly session: Session;
  readonly offer: OfferOf<'elsewhere'>;
}) {
  const { recovery: words, look, memoryName } = messages.value;
  return (
    <>
      <h2 id="recovery-title">{words.title}</h2>
      <p>{words.elsewhere(memoryName(memory))}</p>
      <div class="buttons">
        <button
          type="button"
          disabled={session.runner.busy.value}
          onClick={() => void session.reader.selectMemory(memory)}
        >
          {look.fly(memoryName(memory))}
        </button>
        <NotNow recovery={session.recovery} />
      </div>
    </>
  );
}

interface MemoryLeftProps {
  readonly session: Session;
  readonly offer: OfferOf<'memories'>;
}

function MemoryLeft({ session, offer: { record, current } }: MemoryLeftProps) {
  const { recovery: words, look, timer, memoryName } = messages.value;
  return (
    <>
      <h2 id="recovery-title">{timer['memory-left'].title}</h2>
      <p>{words.left(interruptedText(record), memoryName(record.original), memoryOf(null, current))}</p>
      <div class="buttons">
        <button
          type="button"
          class="primary"
          disabled={session.runner.busy.value}
          onClick={() => void session.reader.selectMemory(record.original)}
        >
          {look.fly(memoryName(record.original))}
        </button>
        <NotNow recovery={session.recovery} />
      </div>
    </>
  );
}

/** For a timer that the offer is not meant for, or a pilot who wants to do nothing about it. */
function NotNow({ recovery }: { readonly recovery: InterruptedJobs }) {
  const { recovery: words } = messages.value;
  return (
    <>
      <button type="button" onClick={() => recovery.setAside()}>
        {words.otherTimer}
      </button>
      <button type="button" class="quiet" onClick={() => void recovery.settle()}>
        {words.leave}
      </button>
    </>
  );
}

/** Each value that the write was to change, or that nothing explains: before, wanted, held. */
function rows({ before, goal }: OfferOf<'write'>['record'], part: OfferOf<'write'>['part'], read: TimerProgram) {
  return [...part.foreign, ...part.missing, ...part.written].map(({ field }) => ({
    field,
    values: [valueAt(before, field), valueAt(goal, field), valueAt(read, field)],
  }));
}
