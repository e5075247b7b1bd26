import type { Clock } from '../line/index.js';
import type { TimerProgram } from '../program/index.js';
import type { TimerError } from './errors.js';
import type { LineEntry } from './log.js';
import type { MemoriesHooks, MemoriesWrite } from './memories.js';
import type { Progress } from './progress.js';
import type { AssumedQuirks } from './quirks.js';

export interface TimerClientOptions {
  /** Bits a second of the line, to know how long bytes take. Default 9600. */
  readonly baudRate?: number;
  /** Default: the real clock. */
  readonly clock?: Clock;
  /** What is known of this timer from an earlier session, or chosen by the pilot. Default: nothing. */
  readonly quirks?: AssumedQuirks | undefined;
  /**
   * Milliseconds beyond the time of the bytes that a reply may take before the request counts as unanswered, at first:
   * it grows when a reply turns out to come later. Default 600.
   */
  readonly margin?: number;
  /** Told of everything on the line. */
  readonly onLine?: ((entry: LineEntry) => void) | undefined;
  /**
   * Told once when the streams end or fail although nobody closed this client. They are watched from the first request
   * on.
   */
  readonly onLost?: ((error: TimerError) => void) | undefined;
}

/** The options of every job. */
export interface JobOptions {
  /**
   * Asks to stop. The exchange under way is waited for, so the port stays usable: at most one reply time. The job
   * rejects with TimerError `aborted`; but a write that has sent something resolves with its report, whose `stopped`
   * says so: what has arrived by then matters more than that it was stopped.
   */
  readonly signal?: AbortSignal | undefined;
  /** Told how far the job is, see {@link Progress}. What it throws harms nothing. */
  readonly onProgress?: ((progress: Progress) => void) | undefined;
}

export interface IdentifyOptions extends JobOptions {
  /**
   * How often the question goes out at most until it is answered, 1 or more. Default: as any other, more often when
   * damage is seen.
   */
  readonly tries?: number | undefined;
  /**
   * A late reply to an earlier call of this method will do as well, so that nothing is asked in between to tell the two
   * apart. Default false.
   */
  readonly anyReply?: boolean | undefined;
}

export interface ReadOptions extends JobOptions {
  /**
   * Asks for the idle throttle on a timer of another class than Q too, where it is not known whether there is one.
   * Default false.
   */
  readonly idleThrottle?: boolean | undefined;
}

export interface MoveOptions {
  /**
   * The pilot agrees that the servos move: each function's positions are sent after a MOVETOFUNC to it, for a timer
   * that keeps them only then (quirk `positions-unchanged`). Default false: nothing moves.
   */
  readonly moveServos?: boolean | undefined;
}

export interface WriteOptions extends JobOptions, MoveOptions {
  /** What the timer held when it was last read. Only what differs from it is sent. */
  readonly baseline: TimerProgram;
}

export interface ReadMemoriesOptions extends ReadOptions, Pick<MemoriesHooks, 'onOriginal'> {
  /** Counted from 0. Default: all that the timer has. */
  readonly memories?: readonly number[] | undefined;
}

export interface WriteMemoriesOptions extends JobOptions, MoveOptions, MemoriesWrite {}
