/**
 * How far a job has come, in bytes of the line, so that it moves as evenly as the line does. It is told when a stage
 * begins, and with each reply; a job on several memories goes through its stages for each of them.
 */
export interface Progress {
  readonly stage: 'read' | 'write' | 'verify' | 'repair';
  /** Bytes of the requests and replies that are over, of all that the job needs on a good line. It never falls. */
  readonly done: number;
  readonly total: number;
  /**
   * How much of the whole job is done, over all its stages and memories: `done` of `total` as 0 to 1. It never falls; 0
   * while nothing is known of the timer, 1 when there is nothing to do.
   */
  readonly fraction: number;
  /** The memory that a job on several is at, counted from 0; null in a job on the current one. */
  readonly memory: number | null;
  /** Requests of this job that went out more than once so far, fences included. */
  readonly repeats: number;
  /**
   * Milliseconds since 1970, by the client's clock, by which the job has ended at the latest, with success or with an
   * error, whatever the line does. While the job runs it moves only by the time that the caller's own `onOriginal` and
   * `onMemory` take, and when the timer turns out to be slower than thought.
   */
  readonly endsBy: number;
}

export type OnProgress = ((progress: Progress) => void) | undefined;
