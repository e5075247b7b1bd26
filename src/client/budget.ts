import type { Clock } from '../line/index.js';
import type { CommandName, Identity } from '../protocol/index.js';
import type { LearnedTiming } from './line-timing.js';
import { longestJob, timeForTheEnd } from './retry-policy.js';

/** Exchanges, on a timer of this layout. */
interface Plan {
  readonly names: readonly CommandName[];
  readonly identity: Identity | null;
}

/** How long the job under way may take, and what it has lost to the line so far. */
export class Budget {
  /** Told, until the job ends, whenever one of its requests goes out again. */
  onRepeat: (() => void) | undefined;
  readonly #clock: Clock;
  readonly #timing: LearnedTiming;
  #repeats = 0;
  #repeatsBefore = 0;
  #endsBy = Number.POSITIVE_INFINITY;
  /** The exchanges of the job, and milliseconds that they may take on a timer as it is known. */
  #plan: Plan | null = null;
  #length = 0;
  /** What the job has to do at its end. */
  readonly #kept = new Set<Plan>();

  constructor(clock: Clock, timing: LearnedTiming) {
    this.#clock = clock;
    this.#timing = timing;
    timing.onSlower = () => this.#lengthen();
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
    this.#plan = { names, identity };
    this.#length = longestJob(names, identity, this.#timing);
    this.#endsBy = this.#clock.now() + this.#length;
  }

  /** Whether something that takes so many milliseconds at most may still begin. */
  hasTimeFor(ms: number): boolean {
    let kept = 0;
    for (const { names, identity } of this.#kept) kept += timeForTheEnd(names, identity, this.#timing);
    return this.#clock.now() + ms <= this.#endsBy - kept;
  }

  /** Does a part of the job in such a way that time is left for these exchanges after it. */
  async keepTimeFor<T>(names: readonly CommandName[], identity: Identity, work: () => Promise<T>): Promise<T> {
    const part = { names, identity };
    this.#kept.add(part);
    try {
      return await work();
    } finally {
      this.#kept.delete(part);
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

  /** The timer turns out to be slower than thought: each exchange is given more, and so is the job. */
  #lengthen(): void {
    if (!this.#plan) return;
    const length = longestJob(this.#plan.names, this.#plan.identity, this.#timing);
    this.#endsBy += length - this.#length;
    this.#length = length;
  }

  countRepeat(): void {
    this.#repeats++;
    this.onRepeat?.();
  }
}
