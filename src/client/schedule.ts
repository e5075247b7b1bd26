import type { Clock } from '../line/index.js';
import type { CommandName, Identity } from '../protocol/index.js';
import { tell } from './callback.js';
import type { OnProgress, Progress } from './progress.js';
import {
  type Exchanges,
  exchangesOf,
  KEPT_FOR_THE_END,
  type LineTiming,
  LOST_TO_DAMAGE,
  longestExchanges,
} from './retry-policy.js';

const NONE: Exchanges = { count: 0, bytes: 0 };

/** A part of a job: what it asks when nothing goes wrong. */
export interface JobPart {
  readonly names: readonly CommandName[];
  /** What is told of it; nothing without one. */
  readonly stage?: Progress['stage'];
  /** The memory that it is about, in a job on several. */
  readonly memory?: number;
}

/** A job that is asked for. */
export interface PlannedJob {
  readonly parts: readonly JobPart[];
  /** What the timer said of itself; null before it has. */
  readonly identity: Identity | null;
  readonly onProgress?: OnProgress;
}

/**
 * The job under way: what it needs, how far it is, and when it has ended at the latest. Each answer moves it on by
 * itself; what has to be asked once more than was planned moves nothing.
 */
export class Schedule {
  /** The memory that a job on several is at. */
  memory: number | null = null;
  readonly #clock: Clock;
  readonly #timing: LineTiming;
  #job: PlannedJob = { parts: [], identity: null };
  /** All that the job asks. */
  #whole = NONE;
  #begin = Number.POSITIVE_INFINITY;
  /** Milliseconds that the caller's own callbacks took. */
  #waited = 0;
  /** Where it stands: the index of a part, what is left of it, and the stage, which may be one that was not planned. */
  #at = 0;
  #left: CommandName[] = [];
  #stage: Progress['stage'] | undefined;
  /** What the job has to do at its end, whatever happens before. */
  readonly #kept = new Set<Exchanges>();
  #repeats = 0;
  #repeatsBefore = 0;

  constructor(clock: Clock, timing: LineTiming) {
    this.#clock = clock;
    this.#timing = timing;
  }

  /** How many requests went out again in all jobs so far, fences included. */
  get repeats(): number {
    return this.#repeatsBefore + this.#repeats;
  }

  /** The clock's time at which this job has ended at the latest: nothing is begun for which there is no time left. */
  get endsBy(): number {
    return this.#begin + this.#waited + this.#timeFor(this.#whole) + LOST_TO_DAMAGE;
  }

  begin(job: PlannedJob): void {
    this.#job = job;
    const names = job.parts.flatMap((part) => part.names);
    this.#whole = exchangesOf(names, job.identity);
    this.#begin = this.#clock.now();
    this.#waited = 0;
    this.memory = null;
    this.#stage = undefined;
    this.#at = 0;
    this.#left = [...(job.parts[0]?.names ?? [])];
    this.#repeatsBefore += this.#repeats;
    this.#repeats = 0;
  }

  /** A stage begins, of the memory that the job is at. One that was not planned moves nothing. */
  enter(stage: Progress['stage']): void {
    const isIt = (part: JobPart): boolean => part.stage === stage && (part.memory ?? null) === this.memory;
    const { parts } = this.#job;
    const next = parts.findIndex((part, index) => index >= this.#at && isIt(part));
    if (next > this.#at) {
      this.#at = next;
      this.#left = [...(parts[next] as JobPart).names];
    }
    this.#stage = stage;
    this.#report();
  }

  /** A request was answered. Behind a part that is done begins one of which no stage is told, such as the way back. */
  answered(name: CommandName): void {
    const next = this.#job.parts[this.#at + 1];
    if (this.#left.length === 0 && next && next.stage === undefined) {
      this.#at++;
      this.#left = [...next.names];
    }
    const index = this.#left.indexOf(name);
    if (index >= 0) this.#left.splice(index, 1);
    this.#report();
  }

  /** A request goes out again. */
  repeated(): void {
    this.#repeats++;
    this.#report();
  }

  /** Whether something that takes so many milliseconds at most may still begin. */
  hasTimeFor(ms: number): boolean {
    let kept = 0;
    for (const exchanges of this.#kept) kept += this.#timeFor(exchanges) + KEPT_FOR_THE_END;
    return this.#clock.now() + ms <= this.endsBy - kept;
  }

  /** Does a part of the job in such a way that time is left for these exchanges after it. */
  async keepTimeFor<T>(names: readonly CommandName[], work: () => Promise<T>): Promise<T> {
    const kept = exchangesOf(names, this.#job.identity);
    this.#kept.add(kept);
    try {
      return await work();
    } finally {
      this.#kept.delete(kept);
    }
  }

  /** Waits for what is not the line's doing: the job may end later by as long as that takes. */
  async waitFor<T>(work: () => T | Promise<T>): Promise<T> {
    const begin = this.#clock.now();
    try {
      return await work();
    } finally {
      this.#waited += this.#clock.now() - begin;
    }
  }

  /**
   * Milliseconds that these exchanges are given while nothing is lost. Twice what they can take at the utmost: each may
   * have to be read twice, and what was written be put right and read back again.
   */
  #timeFor(exchanges: Exchanges): number {
    return 2 * longestExchanges(exchanges, this.#timing);
  }

  #report(): void {
    const { parts, onProgress, identity } = this.#job;
    if (this.#stage === undefined || !onProgress) return;
    const left = [...this.#left, ...parts.slice(this.#at + 1).flatMap(({ names }) => names)];
    // Nothing is known of the sizes before the timer has said what it is.
    const total = identity ? this.#whole.bytes : 0;
    const done = identity ? total - exchangesOf(left, identity).bytes : 0;
    const fraction = total > 0 ? done / total : identity ? 1 : 0;
    const { memory, endsBy } = this;
    tell(onProgress, { stage: this.#stage, done, total, fraction, memory, repeats: this.#repeats, endsBy });
  }
}
