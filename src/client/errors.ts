import type { CommandName } from '../protocol/index.js';

/**
 * What can go wrong between a request and its reply.
 *
 * - `no-answer`: the timer kept silent. `sent` says how often the request went out; a command that moves something may have been
 *   carried out all the same.
 * - `bad-reply`: a reply came each time, with a right checksum and a content that cannot be; `cause` says what.
 * - `unstable`: damage was seen on the line, and no two reads agreed.
 * - `other-memory`: the timer's current memory is not the one that the program was read from.
 * - `other-timer`: the timer that answers is not of the kind that the program is for.
 * - `changed`: after a write more values differ from what was read than the write can have changed: something else changed the
 *   timer, or it is another one. Nothing was put back.
 * - `undecided`: what was read leaves open how times are to be written (quirk `times-big-endian`); the pilot has to choose first.
 * - `port-lost`: the stream of bytes ended: unplugged, closed by someone else; `cause` says how.
 * - `aborted`: the caller's signal asked to stop. The port stays usable.
 * - `closed`: this client was closed.
 */
export type TimerErrorCode =
  | 'no-answer'
  | 'bad-reply'
  | 'unstable'
  | 'other-memory'
  | 'other-timer'
  | 'changed'
  | 'undecided'
  | 'port-lost'
  | 'aborted'
  | 'closed';

export interface TimerErrorDetails {
  /** The request that was under way. */
  readonly request?: CommandName;
  /** How often that request went out. */
  readonly sent?: number;
  readonly expected?: number | null;
  readonly found?: number | null;
}

/** The one error of the client. Its message is for developers. */
export class TimerError extends Error {
  override readonly name = 'TimerError';
  readonly code: TimerErrorCode;
  readonly details: TimerErrorDetails;

  constructor(code: TimerErrorCode, message: string, details: TimerErrorDetails = {}, cause?: unknown) {
    super(message, cause === undefined ? undefined : { cause });
    this.code = code;
    this.details = details;
  }
}

/** @throws TimerError `aborted` when the signal has asked to stop. */
export function throwIfAborted(signal: AbortSignal | undefined): void {
  if (signal?.aborted) throw new TimerError('aborted', 'stopped on request', {}, signal.reason);
}
