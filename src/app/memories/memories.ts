import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { JobContext } from '../timer/job-runner.js';
import type { Session } from '../work/session.js';
import { editMemory } from '../write/edit-memory.js';
import { NotedRoundTrip, type RoundTripParts } from '../write/noted-round-trip.js';

type MemoriesParts = RoundTripParts & Pick<Session, 'connection' | 'runner' | 'backups' | 'notices'>;

/**
 * The memories of the connected timer: which one the pilot looks at, which is in the table, and which flies next.
 * Acts only when the pilot asks for it.
 */
export class Memories {
  /** The memory that the pilot looks at, if it is not the one in the table; null for none. */
  readonly looking: ReadonlySignal<number | null> = computed(() => {
    const { nextFlight, editor, onScreen } = this.#parts;
    const isShown = onScreen.apart.value || !nextFlight.open.value;
    const shown = isShown ? (editor.baseline.value?.memory ?? null) : null;
    return this.#picked.value === shown ? null : this.#picked.value;
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

  /**
   * Shows the last reading of a memory, and sends nothing. The one in the table is shown there, and so is the one that
   * flies next if it was read.
   */
  async show(memory: number): Promise<void> {
    const { nextFlight, reader } = this.#parts;
    const before = this.#picked.peek();
    const isThere = memory === nextFlight.memory.peek() && (await reader.showNext());
    // The pilot may have chosen another one since.
    if (this.#picked.peek() === before) this.#picked.value = isThere ? null : memory;
  }

  /** Shows the program again. */
  endLook(): void {
    this.#picked.value = null;
  }

  /** Opens a memory in the table, by a fresh reading. What flies next stays. */
  async edit(memory: number): Promise<void> {
    this.#picked.value = memory;
    if (await editMemory(this.#parts, memory)) this.#picked.value = null;
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
