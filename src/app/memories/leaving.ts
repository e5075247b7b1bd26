import { effect, signal } from '@preact/signals';
import type { JobKind } from '../timer/job-runner.js';
import type { Session } from '../work/session.js';
import { putBackDt } from '../write/put-back.js';
import type { WriteJob } from '../write/write-job.js';
import type { Memories } from './memories.js';

/**
 * `leave`: as it is. `back`: only after the memory that is meant is current again. `put-back`: only after a write that
 * puts DT back.
 */
export type LeavingAnswer = 'stay' | 'leave' | 'back' | 'put-back';

/** Jobs that select memories. */
const SELECTING: ReadonlySet<JobKind> = new Set(['select', 'look', 'memories']);

type LeavingParts = Pick<Session, 'link' | 'timer' | 'runner' | 'nextFlight' | 'reader' | 'shortDt' | 'editor'>;

/** Ends the connection only after the pilot knows which memory will fly and whether its DT is short. */
export class Leaving {
  // Only this model writes these.
  /** Set while the pilot is asked; `failed` after the way back to the memory that is meant has failed. */
  readonly question = signal<'asked' | 'failed' | null>(null, { name: 'leaving' });
  /** Whether the pilot wanted to leave, and the write on the screen puts DT back first. */
  readonly puttingBack = signal(false, { name: 'puttingBack' });
  readonly #parts: LeavingParts;
  readonly #memories: Memories;
  readonly #write: WriteJob;
  readonly #stopFollowing: () => Promise<void>;
  #answer: (answer: LeavingAnswer) => void = () => {};
  #isLeaving = false;

  constructor(parts: LeavingParts, memories: Memories, write: WriteJob, stopFollowing: () => Promise<void>) {
    this.#parts = parts;
    this.#stopFollowing = stopFollowing;
    this.#memories = memories;
    this.#write = write;
    effect(() => {
      if (parts.link.state.value.status === 'off') this.answer('stay');
    });
  }

  /** Disconnects. Asks first when another memory than the one that is meant flies next, or one with a short DT. */
  async disconnect(): Promise<void> {
    const { runner, timer } = this.#parts;
    const job = runner.job.value;
    // A job that has selected another memory gets the time to come back; otherwise the port would close on its way.
    if (job && SELECTING.has(job.kind) && !job.stopping) await runner.stop();
    // It goes on where it is.
    if (this.#isLeaving) return;
    this.#isLeaving = true;
    // It ends with a reading: nothing that was tried is left uncertain.
    await this.#stopFollowing();
    if (await this.#mayLeave()) await timer.disconnect();
    this.#isLeaving = false;
  }

  /** What the pilot says. */
  answer(answer: LeavingAnswer): void {
    this.question.value = null;
    this.#answer(answer);
  }

  /** Asks as long as there is something to ask. @returns whether the connection may end. */
  async #mayLeave(): Promise<boolean> {
    const { nextFlight, link } = this.#parts;
    let failed = false;
    while (this.#hasToAsk()) {
      const answer = await this.#ask(failed);
      const { value: original } = nextFlight.original;
      if (answer === 'leave') return true;
      if (answer === 'stay') return false;
      if (answer === 'put-back' && !(await this.#putBack())) return false;
      if (answer === 'back' && original !== null) {
        await this.#memories.fly(original);
        if (link.state.value.status === 'off') return false;
        failed = nextFlight.word.value !== null;
      }
    }
    return true;
  }

  #ask(failed: boolean): Promise<LeavingAnswer> {
    this.question.value = failed ? 'failed' : 'asked';
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
    this.puttingBack.value = true;
    await putBackDt(this.#parts, this.#write);
    this.puttingBack.value = false;
    return goesOn;
  }

  /** During a write its end decides; before that nothing is said about the DT. */
  #hasToAsk(): boolean {
    const { nextFlight, shortDt, runner } = this.#parts;
    return nextFlight.word.value !== null || (shortDt.held.value !== null && !runner.writing.value);
  }
}
