import { effect, type ReadonlySignal, signal } from '@preact/signals';
import type { JobKind } from '../session/job-runner.js';
import type { Session } from '../session/session.js';
import { putBackDt } from '../write/put-back.js';
import type { WriteFlow } from '../write/write-flow.js';
import type { Memories } from './memories.js';

/** What the pilot is asked before the connection ends. */
export interface LeavingQuestion {
  /** The memory of the time of connect is being made current again. */
  readonly goingBack: boolean;
  /** That was tried, and did not come to its end. */
  readonly failed: boolean;
}

/** Jobs that select memories. */
const SELECTING: ReadonlySet<JobKind> = new Set(['select', 'look', 'memories']);

/** Ends the connection, and not before the pilot knows which memory will fly, and whether its DT is a short one. */
export class Leaving {
  /** Null while there is nothing to ask. */
  readonly question: ReadonlySignal<LeavingQuestion | null>;
  /** The pilot wanted to go, and puts DT back first: the write that is shown now is for that. */
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

  /** Disconnects; asks before where another memory flies next than at connect, or one with a short DT. */
  async disconnect(): Promise<void> {
    const { runner } = this.#session;
    const job = runner.job.value;
    // What has selected another memory is given the time to come back: the port would be closed on its way.
    if (job && SELECTING.has(job.kind) && !job.stopping) await runner.stop();
    if (this.#hasToAsk()) this.#question.value = { goingBack: false, failed: false };
    else await this.#session.timer.disconnect();
  }

  /** Makes the memory of the time of connect current again, and disconnects when the timer has said that it is. */
  async backAndDisconnect(): Promise<void> {
    const { nextFlight } = this.#session;
    const { original } = nextFlight;
    if (this.#question.value?.goingBack !== false || original.value === null) return;
    this.#question.value = { goingBack: true, failed: false };
    await this.#memories.fly(original.value);
    if (!this.#hasToAsk()) await this.#session.timer.disconnect();
    // The connection may have ended meanwhile.
    else if (this.#question.value) {
      this.#question.value = { goingBack: false, failed: nextFlight.word.value !== null };
    }
  }

  /** Disconnects: the pilot knows which memory flies next, and with which DT. */
  async disconnectAsItIs(): Promise<void> {
    if (this.#question.value?.goingBack === false) await this.#session.timer.disconnect();
  }

  /** Puts a short DT back by a write that is shown first; after it the pilot can go on. */
  async putBack(): Promise<void> {
    if (this.#question.value?.goingBack !== false) return;
    this.#question.value = null;
    this.#puttingBack.value = await putBackDt(this.#session, this.#write);
  }

  /** Stays connected; while the way back is under way, stops it. */
  stay(): void {
    if (this.#question.value?.goingBack) void this.#session.runner.stop();
    else this.#question.value = null;
  }

  /**
   * Escape was pressed. Where a short DT alone is in question it disconnects, as was wanted: in a hurry nothing holds
   * anybody here. Where another memory would fly it stays connected.
   */
  async escape(): Promise<void> {
    if (this.#session.nextFlight.word.value || this.#question.value?.goingBack) this.stay();
    else await this.disconnectAsItIs();
  }

  /** While a write is under way its end decides: nothing is said of the DT before that. */
  #hasToAsk(): boolean {
    const { nextFlight, shortDt, runner } = this.#session;
    return nextFlight.word.value !== null || (shortDt.held.value !== null && !runner.writing.value);
  }
}
