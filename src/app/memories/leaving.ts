import { effect, type ReadonlySignal, signal } from '@preact/signals';
import type { JobKind } from '../session/job-runner.js';
import type { Session } from '../session/session.js';
import { putBackDt } from '../write/put-back.js';
import type { WriteJob } from '../write/write-job.js';
import type { Memories } from './memories.js';

/** What the pilot is asked before the connection ends. */
export interface LeavingQuestion {
  /** Whether the memory that is meant is being made current again. */
  readonly goingBack: boolean;
  /** Whether that was tried and failed. */
  readonly failed: boolean;
}

/**
 * `leave`: as it is. `back`: only after the memory that is meant is current again. `put-back`: only after a write that
 * puts DT back.
 */
export type LeavingAnswer = 'stay' | 'leave' | 'back' | 'put-back';

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
  readonly #write: WriteJob;
  #answer: (answer: LeavingAnswer) => void = () => {};

  constructor(session: Session, memories: Memories, write: WriteJob) {
    this.#session = session;
    this.#memories = memories;
    this.#write = write;
    this.question = this.#question;
    this.puttingBack = this.#puttingBack;
    effect(() => {
      if (session.link.state.value.status === 'off') this.answer('stay');
    });
  }

  /** Disconnects. Asks first when another memory than the one that is meant flies next, or one with a short DT. */
  async disconnect(): Promise<void> {
    const { runner, nextFlight, timer } = this.#session;
    const job = runner.job.value;
    // A job that has selected another memory gets the time to come back; otherwise the port would close on its way.
    if (job && SELECTING.has(job.kind) && !job.stopping) await runner.stop();
    let failed = false;
    while (this.#hasToAsk()) {
      const answer = await this.#ask(failed);
      const { value: original } = nextFlight.original;
      if (answer === 'leave') break;
      if (answer === 'put-back') {
        this.#question.value = null;
        if (!(await this.#putBack())) return;
      } else if (answer === 'back' && original !== null) {
        this.#question.value = { goingBack: true, failed: false };
        await this.#memories.fly(original);
        // The connection may have ended in the meantime.
        if (!this.#question.peek()) return;
        failed = nextFlight.word.value !== null;
      } else {
        return;
      }
    }
    await timer.disconnect();
    this.#question.value = null;
  }

  /** What the pilot says. To stay stops the way back to the first memory, too. */
  answer(answer: LeavingAnswer): void {
    const isGoingBack = this.#question.peek()?.goingBack;
    const isOff = this.#session.link.state.peek().status === 'off';
    if (isGoingBack && !isOff) void this.#session.runner.stop();
    else if (answer === 'stay') this.#question.value = null;
    this.#answer(answer);
  }

  #ask(failed: boolean): Promise<LeavingAnswer> {
    this.#question.value = { goingBack: false, failed };
    return new Promise((resolve) => {
      this.#answer = resolve;
    });
  }

  /** Puts a short DT back by a write that the pilot confirms. @returns whether the pilot then wants to disconnect. */
  async #putBack(): Promise<boolean> {
    let goesOn = false;
    this.#answer = (answer) => {
      goesOn = answer === 'leave';
    };
    this.#puttingBack.value = true;
    await putBackDt(this.#session, this.#write);
    this.#puttingBack.value = false;
    return goesOn;
  }

  /** During a write its end decides; before that nothing is said about the DT. */
  #hasToAsk(): boolean {
    const { nextFlight, shortDt, runner } = this.#session;
    return nextFlight.word.value !== null || (shortDt.held.value !== null && !runner.writing.value);
  }
}
