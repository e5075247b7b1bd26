import { type CommandName, exchangeSize, type Identity } from '../protocol/index.js';
import type { Budget } from './budget.js';
import { tell } from './callback.js';

/** How far a job has come, in bytes of the line, so that it moves as evenly as the line does. */
export interface Progress {
  readonly stage: 'read' | 'write' | 'verify' | 'repair';
  readonly done: number;
  readonly total: number;
  /** The memory that a job on several is at, counted from 0; null in a job on the current one. */
  readonly memory: number | null;
  /** Requests of this job that went out more than once so far, fences included. */
  readonly repeats: number;
  /**
   * Milliseconds since 1970, by the client's clock, by which the job has ended at the latest, with success or with an error, whatever
   * the line does. While the job runs it moves only by the time that the caller's own `onOriginal` and `onMemory` take, and when the timer turns
   * out to be slower than thought.
   */
  readonly endsBy: number;
}

export type OnProgress = ((progress: Progress) => void) | undefined;

/** What a job knows of itself. */
export interface ProgressSource {
  readonly identity: Identity;
  readonly exchange: { readonly budget: Budget };
  readonly onProgress: OnProgress;
}

/** Bytes of the line that these exchanges take. */
export function bytesOf(names: readonly CommandName[], identity: Identity): number {
  return names.reduce((sum, name) => {
    const { request, reply } = exchangeSize(name, identity);
    return sum + request + reply;
  }, 0);
}

/** Counts one stage of a job. While requests are repeated the bar waits, and their number is told. */
export class StageProgress {
  readonly #stage: Progress['stage'];
  readonly #job: ProgressSource;
  readonly #total: number;
  /** What was planned and is not done. */
  readonly #left: CommandName[];
  #done = 0;

  constructor(stage: Progress['stage'], requests: readonly CommandName[], job: ProgressSource) {
    this.#stage = stage;
    this.#job = job;
    this.#total = bytesOf(requests, job.identity);
    this.#left = [...requests];
    job.exchange.budget.onRepeat = () => this.#report();
    this.#report();
  }

  /** One exchange is done. What had to be asked once more than was planned moves nothing. */
  finished(name: CommandName): void {
    const index = this.#left.indexOf(name);
    if (index >= 0) {
      this.#left.splice(index, 1);
      this.#done += bytesOf([name], this.#job.identity);
    }
    this.#report();
  }

  #report(): void {
    const { repeats, endsBy } = this.#job.exchange.budget;
    const progress = { stage: this.#stage, done: this.#done, total: this.#total, memory: null, repeats, endsBy };
    tell(this.#job.onProgress, progress);
  }
}
