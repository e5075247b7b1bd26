import { LATEST_REPLY, type LineTiming } from './retry-policy.js';

/** How much longer than measured to wait, for a timer whose replies do not always take equally long. */
const ROOM = 1.5;
/** One reply later than the latest may come from a program that stood still for a moment. Two make a slow timer. */
const TOO_LATE = 2;

/**
 * The speed of the line, and the delay that was found for this timer.
 * A late reply makes all later requests wait longer.
 */
export class LearnedTiming implements LineTiming {
  readonly baudRate: number;
  margin: number;
  /**
   * How long the slowest late reply took, in milliseconds beyond the time of its bytes; null while none came late. It
   * is counted from the last request that the reply can answer, so after a repeat the timer may really be slower.
   */
  delay: number | null = null;
  /** The delays of the replies in this job that came later than {@link LATEST_REPLY}. */
  #tooLate: number[] = [];

  constructor({ baudRate, margin }: LineTiming) {
    this.baudRate = baudRate;
    this.margin = margin;
  }

  /** The delay of a timer that has turned out in this job to be slower than {@link LATEST_REPLY}; else null. */
  get tooSlow(): number | null {
    return this.#tooLate.length < TOO_LATE ? null : Math.max(...this.#tooLate);
  }

  /** Forgets the replies that came too late: a new job begins. */
  begin(): void {
    this.#tooLate = [];
  }

  /** Notes a late reply: it took `delay` milliseconds more than its bytes, and came after its time was up. */
  learn(delay: number): void {
    if (delay > LATEST_REPLY) {
      this.#tooLate.push(delay);
      this.delay = this.tooSlow ?? this.delay;
    }
    if (delay <= (this.delay ?? 0) || delay > LATEST_REPLY) return;
    this.delay = delay;
    this.margin = Math.max(this.margin, Math.min(LATEST_REPLY, Math.ceil(ROOM * delay)));
  }
}
