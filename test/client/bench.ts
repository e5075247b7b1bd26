import { type LineEntry, TimerClient, type TimerClientOptions } from '../../src/client/index.js';
import { VirtualClock } from '../../src/line/index.js';
import type { TimerProgram } from '../../src/program/index.js';
import { COMMANDS, type CommandName, encodeFrame, type Request } from '../../src/protocol/index.js';
import { VirtualTimer, type VirtualTimerOptions } from '../../src/simulator/index.js';

/** A virtual timer and a client on one clock that the test turns. */
export interface Bench {
  readonly clock: VirtualClock;
  readonly timer: VirtualTimer;
  readonly client: TimerClient;
  /** Everything that was on the line, as the client saw it. */
  readonly line: LineEntry[];
  /** Turns the clock until the promise settles. */
  readonly run: <T>(promise: Promise<T>) => Promise<T>;
}

export function bench(timerOptions: VirtualTimerOptions = {}, clientOptions: TimerClientOptions = {}): Bench {
  const clock = new VirtualClock(1_700_000_000_000);
  const line: LineEntry[] = [];
  const timer = new VirtualTimer({ clock, ...timerOptions });
  const client = new TimerClient(timer, { clock, onLine: (entry) => line.push(entry), ...clientOptions });
  return { clock, timer, client, line, run: (promise) => clock.run(promise) };
}

/** The same after the first reading, which is the baseline of a write. */
export async function readBench(...options: Parameters<typeof bench>): Promise<Bench & { baseline: TimerProgram }> {
  const made = bench(...options);
  return { ...made, baseline: await made.run(made.client.readProgram()) };
}

export function names(requests: readonly Request[]): string[] {
  return requests.map(({ name }) => name);
}

/** What the virtual timer's current memory holds, as a program. */
export function contentOf({ core }: VirtualTimer): TimerProgram {
  return {
    identity: core.identity,
    memory: core.memory,
    times: core.content.times,
    positions: core.content.positions,
    idleThrottle: core.identity.timerClass === 'Q' ? core.idleThrottle : null,
  };
}

/** What one memory of the virtual timer holds, as a program. */
export function memoryOf(timer: VirtualTimer, memory: number): TimerProgram {
  const { times, positions } = timer.core.memories[memory] as { times: number[]; positions: number[][] };
  return structuredClone({ ...contentOf(timer), memory, times, positions });
}

/** What each of its memories holds. */
export function memoriesOf(timer: VirtualTimer): TimerProgram[] {
  return timer.core.memories.map((_, memory) => memoryOf(timer, memory));
}

/** A copy of the program with other values, each given as `[slot, time]` or `[servo, slot, position]`. */
export function edited(
  program: TimerProgram,
  ...values: readonly (readonly [number, number] | readonly [number, number, number])[]
): TimerProgram {
  const times = [...program.times];
  const positions = program.positions.map((row) => [...row]);
  for (const [first, second, position] of values) {
    if (position === undefined) times[first] = second;
    else (positions[first] as number[])[second] = position;
  }
  return { ...program, times, positions };
}

/**
 * Lets the timer answer some requests with other data than it would.
 * @param data by how often it was asked; undefined: its own; null: it keeps silent.
 */
export function answering(
  { core }: VirtualTimer,
  name: CommandName,
  data: (count: number) => readonly number[] | null | undefined,
): void {
  const answer = core.answer.bind(core);
  let count = 0;
  core.answer = (frame, bare) => {
    const other = frame.code === COMMANDS[name].request ? data(count++) : undefined;
    if (other === null) return undefined;
    const reply = answer(frame, bare);
    return other ? encodeFrame(COMMANDS[name].reply, other) : reply;
  };
}
