import type { Finding, TimerProgram } from '../program/index.js';
import type { CommandName, Identity } from '../protocol/index.js';

/**
 * What can go wrong between a request and its reply.
 * - `no-answer`: the timer kept silent, or it does not answer this request. `sent` says how often the request went out.
 *   0 means never, because older requests got no answer either. The timer may have obeyed a command all the same.
 * - `bad-reply`: replies came with a right checksum and an impossible content; `cause` says what. Or each reply to the
 *   request came damaged in the same way (`alike`). Noise is random, so that is none: the timer or its adapter forms
 *   this reply in a way that is not known (quirk `replies-alike`). As after `no-answer`, the timer may have obeyed.
 * - `unstable`: the line damages too many bytes. The repeats were used up, or no two reads agreed. As after
 *   `no-answer`, the timer may have obeyed a request that was `sent`.
 * - `crowded`: no two reads agreed, and frames came that nobody asked for. A second timer or programmer may be in the
 *   beam.
 * - `other-memory`: the timer's current memory is not the one that the program was read from.
 * - `memory-unknown`: the timer does not say which memory is current (quirk `memory-unknown`). So no other memory is
 *   selected, because nobody could tell which one to return to.
 * - `memory-left`: the memory that was current before could not be made current again. `expected` is that memory,
 *   `found` the one that was last selected (null when that is not certain), `cause` what stopped the job or the way
 *   back.
 * - `other-timer`: the timer that answers is of another kind than the program, or not the one that was identified;
 *   `identity` is what it says about itself. Nothing more was sent.
 * - `stale`: the timer holds something else than the caller believed, so nothing was written; `held` is what it holds.
 * - `changed`: in a write, after silence or at the end, the timer held what the write cannot have caused. Something
 *   else changed it, or it is another timer. Nothing was sent again or put back.
 * - `stood-still`: this program stood still for more than ten seconds in the middle of the job, as when the computer
 *   sleeps. Another timer may be under the head by now. Nothing more was sent.
 * - `too-slow`: the timer answers more than three seconds after a request; `delay` says how long it took. Its replies
 *   cannot be told apart safely, so nothing more was sent. As after `no-answer`, it may have obeyed.
 * - `undecided`: the reading leaves open how times are to be written (quirk `times-big-endian`). The pilot has to
 *   choose first.
 * - `serious`: the program may cost a model, and `despite` does not allow it; `findings` says why. Nothing was sent.
 * - `busy`: somebody else reads from the port or writes to it, and holds the lock of its stream. Nothing was sent. Try
 *   again once the lock is released.
 * - `port-lost`: the stream of bytes ended, because the port was unplugged or somebody else closed it; `cause` says
 *   how.
 * - `aborted`: the caller's signal asked to stop. The port stays usable.
 * - `closed`: this client was closed.
 */
export type TimerErrorCode =
  | 'no-answer'
  | 'bad-reply'
  | 'unstable'
  | 'crowded'
  | 'other-memory'
  | 'memory-unknown'
  | 'memory-left'
  | 'other-timer'
  | 'stale'
  | 'changed'
  | 'stood-still'
  | 'too-slow'
  | 'undecided'
  | 'serious'
  | 'busy'
  | 'port-lost'
  | 'aborted'
  | 'closed';

/** Facts about a {@link TimerError}. Each code gives those that it knows. */
export interface TimerErrorDetails {
  /** The request that failed. */
  readonly request?: CommandName;
  /** How often it went out. */
  readonly sent?: number;
  /** Whether the timer answers other requests, as far as is known. */
  readonly answersOthers?: boolean;
  /** The memory that had to be current, counted from 0; null when its number is not known. */
  readonly expected?: number | null;
  /** The memory that is current, counted from 0; null when that is not known. */
  readonly found?: number | null;
  /** What the timer that answers says about itself. */
  readonly identity?: Identity;
  /** What the current memory holds, from a fresh read. */
  readonly held?: TimerProgram;
  /** What the check has found and nobody has agreed to. */
  readonly findings?: readonly Finding[];
  /** Whether each reply was damaged, and all in the same way. */
  readonly alike?: boolean;
  /** How long a reply took beyond the time of its bytes, in milliseconds. */
  readonly delay?: number;
  /** The times or the positions, where only they could be read, by two readings that agree. */
  readonly part?: Pick<TimerProgram, 'identity' | 'memory'> & Partial<Pick<TimerProgram, 'times' | 'positions'>>;
}

/** The one error of the client. Its message is for developers. */
export class TimerError extends Error {
  override readonly name = 'TimerError';
  /** What went wrong. */
  readonly code: TimerErrorCode;
  /** Facts about it. */
  readonly details: TimerErrorDetails;

  /** @param message for developers; the page has its own sentence for each code. */
  constructor(code: TimerErrorCode, message: string, details: TimerErrorDetails = {}, cause?: unknown) {
    super(message, cause === undefined ? undefined : { cause });
    this.code = code;
    this.details = details;
  }

  /** What `structuredClone()`, `postMessage()` and `JSON` can carry. Of the error itself they keep no code. */
  toJSON(): Pick<TimerError, 'name' | 'code' | 'message' | 'details'> {
    return { ...this, message: this.message };
  }
}

/** @throws TimerError `aborted` when the signal has asked to stop. */
export function throwIfAborted(signal: AbortSignal | undefined): void {
  if (signal?.aborted) throw new TimerError('aborted', 'stopped on request', {}, signal.reason);
}
