import type { Frame, RejectionReason } from '../protocol/index.js';

/**
 * An error of the line that the port reported, after which reading went on: `framing`, `parity`, `break` and `overrun`
 * (the buffer of the port was full) are those that Web Serial names, `other` is any other.
 */
export type LineErrorKind = 'framing' | 'parity' | 'break' | 'overrun' | 'other';

/**
 * One thing seen on the line: a frame that was sent, a frame that came, bytes that belong to no frame, or an error of
 * the line.
 */
export interface LineEntry {
  /** Milliseconds since 1970, by the client's clock. */
  readonly time: number;
  readonly direction: 'out' | 'in';
  /** The bytes as they went or came; none for an error of the line. */
  readonly bytes: Uint8Array;
  /** Null for bytes that belong to no frame, and for an error of the line. */
  readonly frame: Frame | null;
  /** Why bytes belong to no frame; else null. */
  readonly rejected: RejectionReason | null;
  /** The error of the line that the port told of; else null. */
  readonly error: LineErrorKind | null;
}

/** The names of the DOMExceptions with which Web Serial lets a stream fail that is replaced by a new one. */
const KINDS: ReadonlyMap<unknown, LineErrorKind> = new Map([
  ['FramingError', 'framing'],
  ['ParityError', 'parity'],
  ['BreakError', 'break'],
  ['BufferOverrunError', 'overrun'],
]);

/** What kind of error of the line a stream failed with. */
export function lineErrorKind(error: unknown): LineErrorKind {
  const { name } = Object(error) as { readonly name?: unknown };
  return KINDS.get(name) ?? 'other';
}
