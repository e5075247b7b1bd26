import type { Clock } from '../line/index.js';
import { STANDSTILL } from './retry-policy.js';

/**
 * Notices that this program stood still: the computer slept, or something held the program up. On some systems the
 * clock of the program stands still with the computer. Then nothing comes late, but the clock on the wall has jumped.
 */
export class StandstillWatch {
  readonly #clock: Clock;
  /** By how much the clock on the wall was ahead of the program's at the last look. */
  #ahead: number;
  /** The same, without the small steps by which somebody sets a clock. */
  #slept: number;
  #count = 0;

  constructor(clock: Clock) {
    this.#clock = clock;
    this.#ahead = this.#measure();
    this.#slept = this.#ahead;
  }

  /** How often the program stood still so far. */
  get count(): number {
    this.#look();
    return this.#count;
  }

  /** Milliseconds since 1970 for a log: as the clock of the program, but the sleep of the computer counts. */
  get time(): number {
    this.#look();
    return this.#clock.now() + this.#slept;
  }

  /** @param due when what has just happened should have happened at the latest. */
  noteDue(due: number): void {
    if (this.#clock.now() > due + STANDSTILL) this.#count++;
  }

  #look(): void {
    const ahead = this.#measure();
    const jump = ahead - this.#ahead;
    this.#ahead = ahead;
    if (jump <= STANDSTILL) return;
    this.#count++;
    this.#slept += jump;
  }

  #measure(): number {
    return this.#clock.wall ? this.#clock.wall() - this.#clock.now() : 0;
  }
}
