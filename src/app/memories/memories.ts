import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { JobContext } from '../timer/job-runner.js';
import type { Session } from '../work/session.js';
import { NotedRoundTrip, type RoundTripParts } from '../write/noted-round-trip.js';

type MemoriesParts = RoundTripParts & Pick<Session, 'connection' | 'runner' | 'backups' | 'notices'>;

/**
 * The memories of the connected timer: which one the pilot looks at, and which flies next.
 * Acts only when the pilot asks for it.
 */
export class Memories {
  /** The memory that the pilot looks at, if it is not the current one; null for none. */
  readonly looking: ReadonlySignal<number | null> = computed(() => {
    const { nextFlight, editor } = this.#parts;
    const current = nextFlight.open.value ? null : (editor.baseline.value?.memory ?? null);
    return this.#picked.value === current ? null : this.#picked.value;
  });
  /** Whether the connected timer does not say which memory is current, so that nobody knows which one to go back to. */
  readonly noWayBack: ReadonlySignal<boolean> = computed(() => {
    const { nextFlight, editor, connection } = this.#parts;
    const baseline = editor.baseline.value;
    return connection.value !== null && baseline?.memory === null && !nextFlight.open.value;
  });
  readonly #picked = signal<number | null>(null, { name: 'picked' });
  readonly #parts: MemoriesParts;

  constructor(parts: MemoriesParts) {
    this.#parts = parts;
    parts.connection.subscribe(() => {
      // The next timer may be another one.
      this.#picked.value = null;
    });
  }

  /** Shows the last reading of a memory, and sends nothing. For the current memory it shows the program. */
  show(memory: number): void {
    this.#picked.value = memory;
  }

  /** Shows the program again. */
  endLook(): void {
    this.#picked.value = null;
  }

  /** Reads a memory, restores the current one, and shows what was read. */
  async look(memory: number): Promise<void> {
    this.#picked.value = memory;
    await this.readOnce(memory);
  }

  /** Reads a memory and restores the current one. */
  async readOnce(memory: number): Promise<void> {
    const { runner, reader } = this.#parts;
    const trip = new NotedRoundTrip(this.#parts, { job: 'look', memory });
    const read = (connection: TimerConnection, options: JobContext) =>
      trip.read(connection, { ...options, memories: [memory] });
    runner.report(await runner.perform('look', read, memory));
    await reader.readIfOpen();
  }

  /** Reads all memories, restores the current one, and keeps a backup of each. */
  async backUp(): Promise<void> {
    const { runner, reader, backups, notices, simulated } = this.#parts;
    const trip = new NotedRoundTrip(this.#parts, { job: 'back-up', memory: null });
    const end = await runner.perform('memories', async (connection, options) => {
      const programs = await trip.read(connection, options);
      const savedAt = Date.now();
      const add = (program: TimerProgram) => backups.add(program, 'memories', simulated.value, savedAt);
      return (await Promise.all(programs.map(add))).every(Boolean);
    });
    runner.report(end);
    if (end.good) notices.sayIfSilent(end.value ? 'backed-up' : 'not-backed-up');
    await reader.readIfOpen();
  }

  /** Makes a memory fly next, and shows it. Edits of the memory before are kept. */
  async fly(memory: number): Promise<boolean> {
    const good = await this.#parts.reader.selectMemory(memory);
    this.#picked.value = null;
    return good;
  }
}
