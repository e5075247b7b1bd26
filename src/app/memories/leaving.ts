import { effect, type ReadonlySignal, signal } from '@preact/signals';
import type { JobKind } from '../session/job-runner.js';
import type { Session } from '../session/session.js';
import { putBackDt } from '../write/put-back.js';
import type { WriteFlow } from '../write/write-flow.js';
import type { Memories } from './memories.js';

/** What the pilot is asked before the connection ends. */
export interface LeavingQuestion {
  /** Whether the memory that is meant is being made current again. */
  readonly goingBack: boolean;
  /** Whether that was tried and failed. */
  readonly failed: boolean;
}

/** Jobs that select memories. */
const SELECTING: ReadonlySet<JobKind> = new Set(['select', 'look', 'memories']);

/** Ends the connection only after the pilot knows which memory will fly and whether its DT is short. */
export class Leaving {
  /** Null while there is nothing to ask. */
  readonly question: ReadonlySignal<LeavingQuestion | null>;
  /** Whether the pilot wanted to leave, and the write on the screen puts DT back first. */
  readonly puttingBack: ReadonlySignal<boolean>;
  readonly #question = signal<LeavingQuestion | null>(null, { name: 'leaving' });
  readonly #puttingBack = signal(false, { name: 'puttingBack' });
  readonly #session: Session;
  readonly #memories: Memories;
  readonly #write: WriteFlow;

  constructor(session: Session, memories: Memories, write: WriteFlow) {
    this.#session = session;
    this.#memories = memories;
    this.#write = write;
    this.question = this.#question;
    this.puttingBack = this.#puttingBack;
    effect(() => {
      if (session.link.state.value.status === 'off') this.#question.value = null;
    });
    effect(() => {
      if (write.current.value === null) this.#puttingBack.value = false;
    });
  }

  /** Disconnects. Asks first when another memory than the one that is meant flies next, or one with a short DT. */
  async disconnect(): Promise<void> {
    const { runner } = this.#session;
    const job = runner.job.value;
    // A job that has selected another memory gets the time to come back; otherwise the port would close on its way.
    if (job && SELECTING.has(job.kind) && !job.stopping) await runner.stop();
    if (this.#hasToAsk()) this.#question.value = { goingBack: false, failed: false };
    else await this.#session.timer.disconnect();
  }

  /** Makes the memory that is meant current again, and disconnects once the timer confirms it. */
  async backAndDisconnect(): Promise<void> {
    const { nextFlight } = this.#session;
    const { original } = nextFlight;
    if (this.#question.value?.goingBack !== false || original.value === null) return;
    this.#question.value = { goingBack: true, failed: false };
    await this.#memories.fly(original.value);
    if (!this.#hasToAsk()) await this.#session.timer.disconnect();
    // The connection may have ended in the meantime.
    else if (this.#question.value) {
      this.#question.value = { goingBack: false, failed: nextFlight.word.value !== null };
    }
  }

  /** Disconnects: the pilot knows which memory flies next, and with which DT. */
  async disconnectAsItIs(): Promise<void> {
    if (this.#question.value?.goingBack === false) await this.#session.timer.disconnect();
  }

  /** Puts a short DT back by a write that the pilot confirms first. Afterwards the pilot can disconnect. */
  async putBack(): Promise<void> {
    if (this.#question.value?.goingBack !== false) return;
    this.#question.value = null;
    this.#puttingBack.value = await putBackDt(this.#session, this.#write);
  }

  /** Stays connected. Stops the way back to the first memory. */
  stay(): void {
    if (this.#question.value?.goingBack) void this.#session.runner.stop();
    else this.#question.value = null;
  }

  /** During a write its end decides; before that nothing is said about the DT. */
  #hasToAsk(): boolean {
    const { nextFlight, shortDt, runner } = this.#session;
    return nextFlight.word.value !== null || (shortDt.held.value !== null && !runner.writing.value);
  }
}
