import { LATEST_REPLY, type LineTiming } from './retry-policy.js';

/** How much longer than measured to wait, for a timer whose replies do not always take equally long. */
const ROOM = 1.5;

/**
 * The speed of the line, and the delay that was found for this timer.
 * A late reply makes all later requests wait longer.
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
   * How long the slowest late reply took, in milliseconds beyond the time of its bytes; null while none came late. It
   * is counted from the last request that the reply can answer, so after a repeat the timer may really be slower.
   */
  get delay(): number | null {
    return this.#delay;
  }

  /** Notes a late reply: it took `delay` milliseconds more than its bytes, and came after its time was up. */
  learn(delay: number): void {
    if (delay <= (this.#delay ?? 0) || delay > LATEST_REPLY) return;
    this.#delay = delay;
    this.#margin = Math.max(this.#margin, Math.min(LATEST_REPLY, Math.ceil(ROOM * delay)));
  }
}
