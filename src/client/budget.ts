import type { Clock } from '../line/index.js';
import type { CommandName, Identity } from '../protocol/index.js';
import { longestJob, type Pace, timeForTheEnd } from './patience.js';

/** How long the job under way may take, and what it has lost to the line so far. */
export class Budget {
  /** Told, until the job ends, whenever one of its requests goes out again. */
  onRepeat: (() => void) | undefined;
  readonly #clock: Clock;
  readonly #pace: Pace;
  #repeats = 0;
  #repeatsBefore = 0;
  #endsBy = Number.POSITIVE_INFINITY;
  /** Milliseconds before that which are kept for what the job has to do at its end. */
  #kept = 0;

  constructor(clock: Clock, pace: Pace) {
    this.#clock = clock;
    this.#pace = pace;
  }

  /** How many requests of this job went out again, fences included. */
  get repeats(): number {
    return this.#repeats;
  }

  /** The same for all jobs so far. */
  get repeatsInAll(): number {
    return this.#repeatsBefore + this.#repeats;
  }

  /** The clock's time at which this job will have ended at the latest: nothing is begun for which there is no time left. */
  get endsBy(): number {
    return this.#endsBy;
  }

  /** A job of these exchanges begins. */
  begin(names: readonly CommandName[], identity: Identity | null): void {
    this.onRepeat = undefined;
    this.#repeatsBefore += this.#repeats;
    this.#repeats = 0;
    this.#endsBy = this.#clock.now() + longestJob(names, identity, this.#pace);
  }

  /** Whether something that takes so many milliseconds at most may still begin. */
  hasTimeFor(ms: number): boolean {
    return this.#clock.now() + ms <= this.#endsBy - this.#kept;
  }

  /** Does a part of the job in such a way that time is left for these exchanges after it. */
  async keepTimeFor<T>(names: readonly CommandName[], identity: Identity, work: () => Promise<T>): Promise<T> {
    const time = timeForTheEnd(names, identity, this.#pace);
    this.#kept += time;
    try {
      return await work();
    } finally {
      this.#kept -= time;
    }
  }

  /** Waits for what is not the line's doing: the job may end later by as long as that takes. */
  async waitFor<T>(work: () => T | Promise<T>): Promise<T> {
    const begin = this.#clock.now();
    try {
      return await work();
    } finally {
      this.#endsBy += this.#clock.now() - begin;
    }
  }

  countRepeat(): void {
    this.#repeats++;
    this.onRepeat?.();
  }
}
