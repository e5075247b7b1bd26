import { useSignal } from '@preact/signals';
import { differences, type ProgramField, type TimerProgram } from '../../program/index.js';
import { clockText, figureText, messages } from '../messages/index.js';
import { type Known, possibleValues } from '../session/known.js';
import type { Session } from '../session/session.js';
import { Timeline } from '../timeline/timeline.js';
import { ValueTable } from '../write/value-table.js';
import type { Memories } from './memories.js';
import './memories-overview.css';

/** All memories of the timer as small pictures, once they were read: to pick one, to copy it, to compare two. */
export function MemoriesOverview({ session, memories }: { readonly session: Session; readonly memories: Memories }) {
  const { overview: words } = messages.value;
  const baseline = session.editor.baseline.value;
  const ready = session.runner.ready.value;
  if (!baseline || baseline.memory === null || baseline.identity.memories < 2) return null;
  const contents = Array.from({ length: baseline.identity.memories }, (_, memory) => ({
    memory,
    known: session.knowledge.of(memory),
  })).filter((each): each is Content => each.known.state !== 'unread');
  return (
    <section class="overview">
      <h2>{words.title}</h2>
      <div class="overview-top">
        <p class="hint">{contents.length < 2 ? words.empty : words.edited}</p>
        <button type="button" disabled={!ready} onClick={() => memories.jobs.open({ kind: 'back-up' })}>
          {words.readAll}
        </button>
      </div>
      {contents.length > 1 && (
        <ul class="overview-list">
          {contents.map(({ memory, known }) => (
            <Memory
              memories={memories}
              key={memory}
              {...{ memory, known, ready }}
              isCurrent={!session.nextFlight.open.value && memory === baseline.memory}
            />
          ))}
        </ul>
      )}
      {contents.length > 1 && <Pair memories={memories} contents={contents} ready={ready} />}
    </section>
  );
}

/** A memory and what was read of it. */
interface Content {
  readonly memory: number;
  readonly known: Exclude<Known, { state: 'unread' }>;
}

interface MemoryProps extends Content {
  readonly memories: Memories;
  readonly isCurrent: boolean;
  readonly ready: boolean;
}

function Memory({ memories, memory, known, isCurrent, ready }: MemoryProps) {
  const { overview: words, nextFlight, look, memoryName } = messages.value;
  const program = lastRead(known);
  const dt: ProgramField = { kind: 'time', slot: program.identity.functions };
  const dts = possibleValues(known, dt).map((value) => figureText(program.identity, dt, value));
  return (
    <li class={`overview-memory ${isCurrent ? 'current' : ''}`}>
      <h2>
        {memoryName(memory)} <span class="hint">{words.dt(dts.join(words.or))}</span>{' '}
        {isCurrent && <span class="badge">{nextFlight.badge}</span>}
      </h2>
      {known.state === 'read' ? (
        <p class="hint">{words.readAt(clockText(known.at))}</p>
      ) : (
        <p class="bad-text">{words.notCertain}</p>
      )}
      <Timeline program={program} compact />
      {!isCurrent && (
        <button type="button" disabled={!ready} onClick={() => void memories.fly(memory)}>
          {look.fly(memoryName(memory))}
        </button>
      )}
    </li>
  );
}

/** What a memory held when it was last read whole. */
function lastRead(known: Content['known']): TimerProgram {
  return known.state === 'read' ? known.program : known.before;
}

interface PairProps {
  readonly memories: Memories;
  readonly contents: readonly Content[];
  readonly ready: boolean;
}

/** Two memories: what differs, and the one into the other. */
function Pair({ memories, contents, ready }: PairProps) {
  const { overview: words, memories: all, memoryName } = messages.value;
  const from = useSignal(contents[0]?.memory ?? 0);
  const to = useSignal(contents[1]?.memory ?? 1);
  const choices = contents.map(({ memory }) => memory);
  const [first, second] = [from, to].map(({ value }) => contents.find(({ memory }) => memory === value)?.known);
  return (
    <section class="overview-pair">
      <h2>{words.compared}</h2>
      <div class="overview-choice">
        {[
          { name: words.from, chosen: from },
          { name: words.to, chosen: to },
        ].map(({ name, chosen }) => (
          <label key={name}>
            {name}
            <select
              value={String(chosen.value)}
              onChange={(event) => {
                chosen.value = Number(event.currentTarget.value);
              }}
            >
              {choices.map((memory) => (
                <option key={memory} value={String(memory)}>
                  {memoryName(memory)}
                </option>
              ))}
            </select>
          </label>
        ))}
        <button
          type="button"
          disabled={!ready || from.value === to.value}
          onClick={() => memories.jobs.open({ kind: 'copy', from: from.value, to: to.value })}
        >
          {all.copy(memoryName(from.value), memoryName(to.value))}
        </button>
      </div>
      {first && second && from.value !== to.value && (
        <Comparison
          first={lastRead(first)}
          second={lastRead(second)}
          names={[memoryName(from.value), memoryName(to.value)]}
        />
      )}
    </section>
  );
}

interface ComparisonProps {
  readonly first: TimerProgram;
  readonly second: TimerProgram;
  readonly names: readonly [string, string];
}

function Comparison({ first, second, names }: ComparisonProps) {
  const { overview: words } = messages.value;
  const changes = differences(first, second);
  if (changes.length === 0) return <p>{words.same}</p>;
  return (
    <>
      <p>{words.differs(changes.length)}</p>
      <Timeline program={first} overlay={{ program: second, name: names[1] }} title={words.picture(...names)} />
      <ValueTable
        identity={first.identity}
        names={names}
        rows={changes.map(({ field, from, to }) => ({ field, values: [from, to] }))}
      />
    </>
  );
}
