import type { Clock } from '../line/index.js';
import { STANDSTILL } from './retry-policy.js';

/** Notices that this program stood still: the computer slept, or something held the program up. */
export class StandstillWatch {
  readonly #clock: Clock;
  /** By how much the wall clock was ahead at the last look. */
  #ahead: number;
  #count = 0;

  constructor(clock: Clock) {
    this.#clock = clock;
    this.#ahead = this.#measure();
  }

  /** How often the program stood still so far. */
  get count(): number {
    // On some systems the clock of the program stands still with the computer, and nothing seems late.
    const ahead = this.#measure();
    if (ahead > this.#ahead + STANDSTILL) this.#count++;
    this.#ahead = ahead;
    return this.#count;
  }

  /** @param due when what has just happened should have happened at the latest. */
  noteDue(due: number): void {
    if (this.#clock.now() > due + STANDSTILL) this.#count++;
  }

  #measure(): number {
    return this.#clock.wall ? this.#clock.wall() - this.#clock.now() : 0;
  }
}
