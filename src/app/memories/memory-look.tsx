import { clockText, messages } from '../messages/index.js';
import { keyFigures } from '../messages/key-figures.js';
import { memoryName } from '../messages/names.js';
import { ProgramGrid } from '../timeline/program-grid.js';
import { Timeline } from '../timeline/timeline.js';
import { type Known, openValues } from '../timer/known.js';
import { memoryText } from '../work/memory-names.js';
import type { Session } from '../work/session.js';
import { ValueTable } from '../write/value-table.js';
import type { Memories } from './memories.js';
import './memory-look.css';

interface MemoryLookProps {
  readonly session: Session;
  readonly memories: Memories;
  readonly memory: number;
}

/** Shows the last reading of a memory that is not in the table, and the two ways to it. */
export function MemoryLook({ session, memories, memory }: MemoryLookProps) {
  const { look: words, program, timer } = messages.value;
  const { nextFlight, runner } = session;
  const name = memoryText(session, memory);
  const { known } = session.standings.of(memory);
  const current = nextFlight.memory.value;
  // Not during a job. A disabled button would lose the focus, so it stays enabled.
  const isBusy = !runner.ready.value;
  const noWayBack = memories.noWayBack.value;
  return (
    <section class="stack memory-look" aria-labelledby="look-title">
      <div role="status">
        <h2 id="look-title">{headline(known, name)}</h2>
      </div>
      {current !== null && <p class="hint">{words.lead({ current: memoryText(session, current) })}</p>}
      <div class="row look-way">
        <button
          type="button"
          aria-disabled={isBusy}
          disabled={noWayBack}
          onClick={() => void (!isBusy && memories.edit(memory))}
        >
          {words.edit({ memory: name })}
        </button>
        {noWayBack && <p class="hint">{timer['memory-unknown'].advice}</p>}
        {current !== null && current !== memory && (
          <p class="hint">{words.hint({ memory: name, current: memoryName(current) })}</p>
        )}
      </div>
      <div class="buttons">
        {current !== memory && (
          <button type="button" aria-disabled={isBusy} onClick={() => void (!isBusy && memories.fly(memory))}>
            {words.fly({ memory: name })}
          </button>
        )}
        {current !== null && current !== memory && (
          <button type="button" class="quiet" onClick={() => void memories.show(current)}>
            {words.show({ memory: memoryName(current) })}
          </button>
        )}
      </div>
      {known.state === 'read' && (
        <>
          <p class="row held-figures">
            {keyFigures(known.program).map(({ label, text }, at) => {
              // DT comes first.
              const isShort = at === 0 && session.shortDt.isShort(known.program);
              return (
                <span key={label} class={isShort ? 'bad-text' : ''}>
                  {isShort ? program.shortDt : label} <strong>{text}</strong>
                </span>
              );
            })}
          </p>
          <ProgramGrid program={known.program} caption={program.tableCaption} />
        </>
      )}
      {known.state === 'uncertain' && (
        <ValueTable
          identity={known.before.identity}
          names={[words.either, words.or]}
          rows={openValues(known).map(({ field, from, to }) => ({ field, values: [from, to] }))}
        />
      )}
    </section>
  );
}

/** The last reading of a memory over time, without handles. */
export function MemoryPicture({ session, memory }: Pick<MemoryLookProps, 'session' | 'memory'>) {
  const { look: words, timeline } = messages.value;
  const { known } = session.standings.of(memory);
  if (known.state === 'unread') return null;
  const { title } = timeline;
  if (known.state === 'read') return <Timeline program={known.program} title={title} />;
  return <Timeline program={known.before} overlay={{ program: known.goal, name: words.or }} title={title} />;
}

/** “M3, read 14:32”. */
function headline(known: Known, name: string): string {
  const { look: words, knowledge } = messages.value;
  if (known.state === 'read') return words.read({ memory: name, time: clockText(known.at) });
  return known.state === 'unread' ? words.notRead({ memory: name }) : knowledge.unknown({ memory: name });
}
