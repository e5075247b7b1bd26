import type { Clock } from '../line/index.js';
import type { TimerProgram } from '../program/index.js';
import type { DespiteOptions } from './despite.js';
import type { TimerError } from './errors.js';
import type { LineEntry } from './log.js';
import type { Progress } from './progress.js';
import type { AssumedQuirks } from './quirks.js';

/** How a client is made. Nothing is required. */
export interface TimerClientOptions {
  /** Bits a second of the line, to work out how long bytes take. Default 9600. */
  readonly baudRate?: number;
  /** Default: the real clock. */
  readonly clock?: Clock;
  /** What is known of this timer from an earlier session, or what the pilot has chosen. Default: nothing. */
  readonly quirks?: AssumedQuirks | undefined;
  /**
   * How long a reply may take beyond the time of its bytes, in milliseconds. Later the request counts as unanswered.
   * The value grows when replies turn out to come later. Default 600.
   */
  readonly margin?: number;
  /** Called with everything on the line. */
  readonly onLine?: ((entry: LineEntry) => void) | undefined;
  /**
   * Called once when the streams end or fail although nobody closed this client.
   * The client watches them from its first request on.
   */
  readonly onLost?: ((error: TimerError) => void) | undefined;
}

/** The options of every job. */
export interface JobOptions {
  /**
   * Asks to stop. The job waits for the exchange in progress, at most one reply time, so the port stays usable. Then it
   * rejects with TimerError `aborted`. A write that has already sent something resolves with its report instead, whose
   * `stopped` says so: what has arrived matters more than the stop.
   */
  readonly signal?: AbortSignal | undefined;
  /**
   * Called with how far a job in stages is, see {@link Progress}: a reading or a write. Single requests, `identify()`,
   * `selectMemory()` and `setIdleThrottle()` do not call it. An error that it throws does no harm.
   */
  readonly onProgress?: ((progress: Progress) => void) | undefined;
}

/** The options of `identify()`. */
export interface IdentifyOptions extends JobOptions {
  /**
   * How often the question goes out at most, 1 or more. Default: as for other requests, which go out more often when
   * there is damage.
   */
  readonly tries?: number | undefined;
  /**
   * Accepts a late reply to an earlier call of this method.
   * Then nothing has to be sent to tell the two apart. Default false.
   */
  readonly anyReply?: boolean | undefined;
}

/** The options of `readProgram()`. */
export interface ReadOptions extends JobOptions {
  /**
   * Asks for the idle throttle also on a timer of another class than Q,
   * where nobody knows whether there is one. Default false.
   */
  readonly idleThrottle?: boolean | undefined;
}

/** Whether a write may move the servos. */
export interface MoveOptions {
  /**
   * The pilot agrees that the servos move. The positions of each function are then sent after a MOVETOFUNC to it, for a
   * timer that keeps them only so (quirk `positions-unchanged`). Default false: nothing moves.
   */
  readonly moveServos?: boolean | undefined;
}

/** The options of `writeProgram()`. */
export interface WriteOptions extends JobOptions, MoveOptions, DespiteOptions {
  /** What the timer held when it was last read. Only values that differ from it are sent. */
  readonly baseline: TimerProgram;
}

/**
 * Functions that a job on several memories calls on its way. When one returns a promise, the job waits for it; when
 * that promise rejects, the job fails, too.
 */
export interface MemoriesHooks {
  /**
   * Called with the current memory, counted from 0, before the first other memory is selected.
   * Keep it until it is current again.
   */
  readonly onOriginal?: ((original: number) => unknown) | undefined;
  /** Called with what a memory holds, before the first SET in it. Keep it as a backup. */
  readonly onMemory?: ((read: TimerProgram, goal: TimerProgram) => unknown) | undefined;
}

/** The options of `readMemories()`. */
export interface ReadMemoriesOptions extends ReadOptions, Pick<MemoriesHooks, 'onOriginal'> {
  /** Counted from 0. Default: all that the timer has. */
  readonly memories?: readonly number[] | undefined;
}

/** The options of `writeMemories()`. */
export interface WriteMemoriesOptions extends JobOptions, MoveOptions, DespiteOptions, MemoriesHooks {
  /**
   * What the memories held when the pilot agreed to the write. Each entry names its memory. A memory that holds
   * something else now is not written, and the job stops with `stale`. A memory without an entry is written whatever it
   * holds.
   */
  readonly baselines?: readonly TimerProgram[] | undefined;
}
