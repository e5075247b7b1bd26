import { useSignal } from '@preact/signals';
import { differences, type TimerProgram } from '../../program/index.js';
import { formatValue } from '../edit/content.js';
import { messages } from '../messages/index.js';
import { useModels } from '../models.js';
import { Timeline } from '../timeline/timeline.js';
import { ValueTable } from './value-table.js';

/** All memories of the timer as small pictures, once they were read: to pick one, to copy it, to compare two. */
export function MemoriesOverview() {
  const { session, memories } = useModels();
  const { overview: words } = messages.value;
  const contents = [...memories.contents.value].sort(([a], [b]) => a - b);
  const baseline = session.editor.baseline.value;
  const ready = session.connection.value !== null && !session.busy.value;
  if (!baseline || baseline.memory === null || baseline.identity.memories < 2) return null;
  return (
    <details class="overview">
      <summary>{words.title}</summary>
      <div class="overview-top">
        <p class="hint">{contents.length === 0 ? words.empty : words.edited}</p>
        <button type="button" disabled={!ready} onClick={() => memories.open({ kind: 'back-up' })}>
          {words.readAll}
        </button>
      </div>
      {contents.length > 0 && (
        <ul class="overview-list">
          {contents.map(([memory, program]) => (
            <Memory key={memory} {...{ memory, program, ready }} isCurrent={memory === baseline.memory} />
          ))}
        </ul>
      )}
      {contents.length > 1 && <Pair contents={contents} ready={ready} />}
    </details>
  );
}

interface MemoryProps {
  readonly memory: number;
  readonly program: TimerProgram;
  readonly isCurrent: boolean;
  readonly ready: boolean;
}

function Memory({ memory, program, isCurrent, ready }: MemoryProps) {
  const { session } = useModels();
  const { overview: words, memoryName, seconds } = messages.value;
  const column = program.identity.functions;
  const dt = formatValue({ kind: 'time', column }, program.timers[column] ?? 0);
  return (
    <li class={`overview-memory ${isCurrent ? 'current' : ''}`}>
      <h2>
        {memoryName(memory)} <span class="hint">{words.dt(seconds(dt))}</span>{' '}
        {isCurrent && <span class="badge">{words.current}</span>}
      </h2>
      <Timeline program={program} compact />
      {!isCurrent && (
        <button type="button" disabled={!ready} onClick={() => void session.selectMemory(memory)}>
          {words.pick(memoryName(memory))}
        </button>
      )}
    </li>
  );
}

interface PairProps {
  readonly contents: readonly (readonly [number, TimerProgram])[];
  readonly ready: boolean;
}

/** Two memories: what differs, and the one into the other. */
function Pair({ contents, ready }: PairProps) {
  const { memories } = useModels();
  const { overview: words, memories: all, memoryName } = messages.value;
  const from = useSignal(contents[0]?.[0] ?? 0);
  const to = useSignal(contents[1]?.[0] ?? 1);
  const byMemory = new Map(contents);
  const first = byMemory.get(from.value);
  const second = byMemory.get(to.value);
  const choices = contents.map(([memory]) => memory);
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
          onClick={() => memories.open({ kind: 'copy', from: from.value, to: to.value })}
        >
          {all.copy(memoryName(from.value), memoryName(to.value))}
        </button>
      </div>
      {first && second && from.value !== to.value && (
        <Comparison first={first} second={second} names={[memoryName(from.value), memoryName(to.value)]} />
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
