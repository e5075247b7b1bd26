import type { Clock } from '../line/index.js';
import type { CommandName, Identity } from '../protocol/index.js';
import { tell } from './callback.js';
import type { Progress } from './progress.js';
import {
  type Exchanges,
  exchangesOf,
  KEPT_FOR_THE_END,
  type LineTiming,
  LOST_TO_DAMAGE,
  longestExchanges,
} from './retry-policy.js';

const NONE: Exchanges = { count: 0, bytes: 0 };

/** A part of a job: its exchanges when nothing goes wrong. */
export interface JobPart {
  readonly names: readonly CommandName[];
  /** The stage that is reported for it. A part without one is not reported. */
  readonly stage?: Progress['stage'];
  /** The memory that it works on, in a job on several. */
  readonly memory?: number;
}

/** The plan of a job. */
export interface PlannedJob {
  readonly parts: readonly JobPart[];
  /** What the timer said about itself; null before that. */
  readonly identity: Identity | null;
  readonly onProgress?: ((progress: Progress) => void) | undefined;
}

/**
 * The job in progress: what it needs, how far it is, and when it will have ended at the latest. Each planned answer
 * moves it on. A request that was not planned moves nothing.
 */
export class Schedule {
  /** The memory that a job on several memories is at. */
  memory: number | null = null;
  readonly #clock: Clock;
  readonly #timing: LineTiming;
  #job: PlannedJob = { parts: [], identity: null };
  /** All exchanges of the job. */
  #whole = NONE;
  #begin = Number.POSITIVE_INFINITY;
  /** Milliseconds that the caller's own callbacks took. */
  #waited = 0;
  /** Where the job is: the index of a part, its remaining exchanges, and the stage, which may be an unplanned one. */
  #at = 0;
  #left: CommandName[] = [];
  #stage: Progress['stage'] | undefined;
  /** The exchanges that the job must still do at its end, whatever happens before. */
  readonly #kept = new Set<Exchanges>();
  #repeats = 0;
  #repeatsBefore = 0;

  constructor(clock: Clock, timing: LineTiming) {
    this.#clock = clock;
    this.#timing = timing;
  }

  /** How many requests were repeated in all jobs so far, fences included. */
  get repeats(): number {
    return this.#repeatsBefore + this.#repeats;
  }

  /** When this job will have ended at the latest, by the clock. Nothing begins for which there is no time left. */
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

  /** Begins a stage for the current memory. A stage that was not planned moves nothing. */
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

  /** Notes an answer. After a finished part may follow one without a stage, such as the way back. */
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

  /** Notes that nothing else of the plan is needed. */
  finish(): void {
    this.#at = this.#job.parts.length;
    this.#left = [];
    this.#report();
  }

  /** Notes that a request goes out again. */
  repeated(): void {
    this.#repeats++;
    this.#report();
  }

  /** Whether something that takes at most `ms` milliseconds may still begin. */
  hasTimeFor(ms: number): boolean {
    let kept = 0;
    for (const exchanges of this.#kept) kept += this.#timeFor(exchanges) + KEPT_FOR_THE_END;
    return this.#clock.now() + ms <= this.endsBy - kept;
  }

  /** Does a part of the job, and reserves time for these exchanges after it. */
  async keepTimeFor<T>(names: readonly CommandName[], work: () => Promise<T>): Promise<T> {
    const kept = exchangesOf(names, this.#job.identity);
    this.#kept.add(kept);
    try {
      return await work();
    } finally {
      this.#kept.delete(kept);
    }
  }

  /** Waits for the caller's own work. The job may end later by as long as that takes. */
  async waitFor<T>(work: () => T | Promise<T>): Promise<T> {
    const begin = this.#clock.now();
    try {
      return await work();
    } finally {
      this.#waited += this.#clock.now() - begin;
    }
  }

  /**
   * Milliseconds for these exchanges when no time is lost to damage. Twice their longest time: each value may have to
   * be read twice, and a write may have to be put right and read back again.
   */
  #timeFor(exchanges: Exchanges): number {
    return 2 * longestExchanges(exchanges, this.#timing);
  }

  #report(): void {
    const { parts, onProgress, identity } = this.#job;
    if (this.#stage === undefined || !onProgress) return;
    const left = [...this.#left, ...parts.slice(this.#at + 1).flatMap(({ names }) => names)];
    // Sizes are not known before the timer has said what it is.
    const total = identity ? this.#whole.bytes : 0;
    const done = identity ? total - exchangesOf(left, identity).bytes : 0;
    const fraction = total > 0 ? done / total : identity ? 1 : 0;
    const { memory, endsBy } = this;
    tell(onProgress, { stage: this.#stage, done, total, fraction, memory, repeats: this.#repeats, endsBy });
  }
}
