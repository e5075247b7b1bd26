import { type TimerProgram, valueAt } from '../../program/index.js';
import { dateText, messages } from '../messages/index.js';
import { useModels } from '../models.js';
import type { Offer } from '../session/interrupted-jobs.js';
import { ValueTable } from './value-table.js';

/** What an earlier job left behind on a timer of this kind, and what can be done about it. */
export function RecoveryPanel() {
  const { session, write } = useModels();
  const offer = session.recovery.offer.value;
  // In the middle of something else it waits.
  if (!offer || write.current.value) return null;
  return (
    <section class="recovery notice bad" aria-labelledby="recovery-title">
      {offer.kind === 'write' && <InterruptedWrite offer={offer} />}
      {offer.kind === 'elsewhere' && <WriteElsewhere offer={offer} />}
      {offer.kind === 'memories' && <MemoryLeft offer={offer} />}
    </section>
  );
}

type OfferOf<Kind extends Offer['kind']> = Extract<Offer, { kind: Kind }>;

function InterruptedWrite({ offer: { record, part, read } }: { offer: OfferOf<'write'> }) {
  const { session, recover } = useModels();
  const { recovery: words } = messages.value;
  const busy = session.busy.value || !session.connection.value;
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
        {words.when(memoryText(record.goal.memory), dateText(record.startedAt))} {said}
      </p>
      <details>
        <summary>{words.compare}</summary>
        <ValueTable
          identity={read.identity}
          names={[words.before, words.goal, words.held]}
          rows={rows(record, part, read)}
        />
      </details>
      {!isForeign && <p class="hint">{words.sure}</p>}
      <div class="buttons">
        {isForeign ? (
          <>
            <button type="button" onClick={() => session.recovery.setAside()}>
              {words.otherTimer}
            </button>
            <button type="button" disabled={busy} onClick={() => void recover.show()}>
              {words.sameTimer}
            </button>
          </>
        ) : (
          <>
            <button type="button" class="primary" disabled={busy} onClick={() => void recover.finish()}>
              {words.finish}
            </button>
            {part.extent === 'part' && (
              <button type="button" disabled={busy} onClick={() => void recover.goBack()}>
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

function WriteElsewhere({ offer: { memory } }: { offer: OfferOf<'elsewhere'> }) {
  const { session } = useModels();
  const { recovery: words, memoryName } = messages.value;
  return (
    <>
      <h2 id="recovery-title">{words.title}</h2>
      <p>{words.elsewhere(memoryName(memory))}</p>
      <div class="buttons">
        <button type="button" disabled={session.busy.value} onClick={() => void session.selectMemory(memory)}>
          {words.show(memoryName(memory))}
        </button>
        <NotNow />
      </div>
    </>
  );
}

function MemoryLeft({ offer: { record, current } }: { offer: OfferOf<'memories'> }) {
  const { session } = useModels();
  const { recovery: words, memoryName } = messages.value;
  return (
    <>
      <h2 id="recovery-title">{words.leftTitle}</h2>
      <p>{words.left(memoryName(record.original), memoryText(current))}</p>
      <div class="buttons">
        <button
          type="button"
          class="primary"
          disabled={session.busy.value}
          onClick={() => void session.selectMemory(record.original)}
        >
          {words.makeCurrent(memoryName(record.original))}
        </button>
        <NotNow />
      </div>
    </>
  );
}

/** It is another timer, for which the offer is not meant; or nothing shall be done about it. */
function NotNow() {
  const { session } = useModels();
  const { recovery: words } = messages.value;
  return (
    <>
      <button type="button" onClick={() => session.recovery.setAside()}>
        {words.otherTimer}
      </button>
      <button type="button" class="quiet" onClick={() => void session.recovery.settle()}>
        {words.leave}
      </button>
    </>
  );
}

function memoryText(memory: number | null): string {
  const { recovery, memoryName } = messages.value;
  return memory === null ? recovery.unknownMemory : memoryName(memory);
}

/** Every value that the write was to change, or that nothing explains: before, wanted, held. */
function rows({ before, goal }: OfferOf<'write'>['record'], part: OfferOf<'write'>['part'], read: TimerProgram) {
  return [...part.foreign, ...part.missing, ...part.written].map(({ field }) => ({
    field,
    values: [valueAt(before, field), valueAt(goal, field), valueAt(read, field)],
  }));
}
