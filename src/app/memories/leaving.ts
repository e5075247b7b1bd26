import { effect, type ReadonlySignal, signal } from '@preact/signals';
import type { JobKind } from '../session/job-runner.js';
import type { Session } from '../session/session.js';
import type { Memories } from './memories.js';

/** What the pilot is asked before the connection ends. */
export interface Question {
  /** The memory of the time of connect is being made current again. */
  readonly goingBack: boolean;
  /** That was tried, and did not come to its end. */
  readonly failed: boolean;
}

/** Jobs that select memories. */
const SELECTING: ReadonlySet<JobKind> = new Set(['select', 'look', 'memories']);

/** Ends the connection, and not before the pilot knows which memory will fly. */
export class Leaving {
  /** Null while there is nothing to ask. */
  readonly question: ReadonlySignal<Question | null>;
  readonly #question = signal<Question | null>(null, { name: 'leaving' });
  readonly #session: Session;
  readonly #memories: Memories;

  constructor(session: Session, memories: Memories) {
    this.#session = session;
    this.#memories = memories;
    this.question = this.#question;
    effect(() => {
      if (session.link.state.value.status === 'off') this.#question.value = null;
    });
  }

  /** Disconnects; asks before where another memory flies next than at connect. */
  async disconnect(): Promise<void> {
    const { runner, nextFlight } = this.#session;
    const job = runner.job.value;
    // What has selected another memory is given the time to come back: the port would be closed on its way.
    if (job && SELECTING.has(job.kind) && !job.stopping) await runner.stop();
    if (nextFlight.word.value) this.#question.value = { goingBack: false, failed: false };
    else await this.#session.disconnect();
  }

  /** Makes the memory of the time of connect current again, and disconnects when the timer has said that it is. */
  async backAndDisconnect(): Promise<void> {
    const { nextFlight } = this.#session;
    const { original } = nextFlight;
    if (this.#question.value?.goingBack !== false || original.value === null) return;
    this.#question.value = { goingBack: true, failed: false };
    await this.#memories.fly(original.value);
    if (!nextFlight.word.value) await this.#session.disconnect();
    // The connection may have ended meanwhile.
    else if (this.#question.value) this.#question.value = { goingBack: false, failed: true };
  }

  /** Disconnects: the pilot knows which memory flies next. */
  async disconnectAsItIs(): Promise<void> {
    if (this.#question.value?.goingBack === false) await this.#session.disconnect();
  }

  /** Stays connected; while the way back is under way, stops it. */
  stay(): void {
    if (this.#question.value?.goingBack) void this.#session.runner.stop();
    else this.#question.value = null;
  }
}
