/**
 * How far a job has come, in bytes on the line, so that it moves as evenly as the line does. It is reported at the
 * beginning of each stage and with each reply. A job on several memories goes through its stages once for each memory.
 */
export interface Progress {
  /**
   * `read`: reads. `write`: sends values. `verify`: reads them back. `repair`: puts back, or sends again, what differs.
   */
  readonly stage: 'read' | 'write' | 'verify' | 'repair';
  /** Bytes of the finished requests and replies. It never falls. */
  readonly done: number;
  /** Bytes of all requests and replies that the job needs on a good line. 0 while nothing is known of the timer. */
  readonly total: number;
  /**
   * The finished part of the whole job, over all stages and memories: `done` / `total`, 0 to 1. It never falls. 0 while
   * nothing is known of the timer; 1 when there is nothing to do.
   */
  readonly fraction: number;
  /** The memory that a job on several memories is at, counted from 0; null in a job on the current one. */
  readonly memory: number | null;
  /** How often this job has repeated a request so far, fences included. */
  readonly repeats: number;
  /**
   * When the job will have ended at the latest, with success or an error, whatever the line does. Milliseconds since
   * 1970, by the client's clock. It changes only when the caller's own `onOriginal` and `onMemory` take time, and when
   * the timer turns out to be slower than thought.
   */
  readonly endsBy: number;
}
