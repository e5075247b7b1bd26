import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { TimerConnection } from '../../serial/index.js';
import type { JobContext } from '../session/job-runner.js';
import type { Session } from '../session/session.js';
import { MemoryJobs } from './memory-jobs.js';
import { NotedRoundTrip } from './noted-round-trip.js';

/**
 * The memories of the connected timer: which one the pilot looks at, and which flies next.
 * Acts only when the pilot asks for it.
 */
export class Memories {
  /** Back up all memories, copy one to another, restore several. */
  readonly jobs: MemoryJobs;
  /** The memory that the pilot looks at, if it is not the current one; null for none. */
  readonly looking: ReadonlySignal<number | null> = computed(() => {
    const { nextFlight, editor } = this.#session;
    const current = nextFlight.open.value ? null : (editor.baseline.value?.memory ?? null);
    return this.#picked.value === current ? null : this.#picked.value;
  });
  /** Whether the connected timer does not say which memory is current, so that nobody knows which one to go back to. */
  readonly noWayBack: ReadonlySignal<boolean> = computed(() => {
    const { nextFlight, editor, connection } = this.#session;
    const baseline = editor.baseline.value;
    return connection.value !== null && baseline?.memory === null && !nextFlight.open.value;
  });
  readonly #picked = signal<number | null>(null, { name: 'picked' });
  readonly #session: Session;
  readonly #roundTrip: NotedRoundTrip;

  constructor(session: Session) {
    this.#session = session;
    this.#roundTrip = new NotedRoundTrip(session);
    this.jobs = new MemoryJobs(session, this.#roundTrip);
    session.connection.subscribe(() => {
      // The next timer may be another one.
      this.#picked.value = null;
    });
  }

  /** Shows the last reading of a memory, and sends nothing. For the current memory it shows the program. */
  show(memory: number): void {
    this.#picked.value = memory;
  }

  /** Reads a memory, restores the current one, and shows what was read. */
  async look(memory: number): Promise<void> {
    this.#picked.value = memory;
    await this.readOnce(memory);
  }

  /** Reads a memory and restores the current one. */
  async readOnce(memory: number): Promise<void> {
    const work = async (connection: TimerConnection, options: JobContext): Promise<void> => {
      await this.#roundTrip.read(connection, { ...options, memories: [memory] });
    };
    this.#roundTrip.trip = { job: 'look', memory };
    await this.#session.runner.run('look', work, memory);
    await this.#session.reader.readIfOpen();
  }

  /** Makes a memory fly next, and shows it. Edits of the memory before are kept. */
  async fly(memory: number): Promise<boolean> {
    const good = await this.#session.reader.selectMemory(memory);
    this.#picked.value = null;
    return good;
  }
}
