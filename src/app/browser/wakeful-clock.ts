import { type Clock, realClock } from '../../line/index.js';

/**
 * The real clock, which also counts the sleep of the computer. On some systems the clock of a page stands still
 * meanwhile: a write would go on after a night as if nothing had been, and the line would be logged at the wrong time.
 */
export class WakefulClock implements Clock {
  /** How far the clock of the day is ahead of the page's, in milliseconds. It only grows: time never runs back. */
  #ahead = 0;

  now(): number {
    const own = realClock.now();
    this.#ahead = Math.max(this.#ahead, Date.now() - own);
    return own + this.#ahead;
  }

  after(ms: number, callback: () => void): () => void {
    return realClock.after(ms, callback);
  }
}
