import { LATEST_REPLY, type LineTiming } from './retry-policy.js';

/** Room for a timer that does not always take equally long. */
const ROOM = 1.5;

/**
 * The speed of the line, and how slow the timer was found to be: a reply that came late makes later requests wait
 * longer.
 */
export class LearnedTiming implements LineTiming {
  readonly baudRate: number;
  #margin: number;
  #delay: number | null = null;

  constructor({ baudRate, margin }: LineTiming) {
    this.baudRate = baudRate;
    this.#margin = margin;
  }

  get margin(): number {
    return this.#margin;
  }

  /**
   * Milliseconds, beyond those of the bytes, after which the slowest late reply came; null while none came late.
   * Counted from the last request that it can answer: after a repeat the timer may be slower than this.
   */
  get delay(): number | null {
    return this.#delay;
  }

  /** A reply came so many milliseconds later than its bytes take, after its time was up. */
  learn(delay: number): void {
    if (delay <= (this.#delay ?? 0) || delay > LATEST_REPLY) return;
    this.#delay = delay;
    this.#margin = Math.max(this.#margin, Math.min(LATEST_REPLY, Math.ceil(ROOM * delay)));
  }
}
