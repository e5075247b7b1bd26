import type { Bytes, Frame, RejectionReason } from '../protocol/index.js';

/**
 * An error of the line that the port reported. Reading went on after it. Web Serial names `framing`, `parity`, `break`
 * and `overrun` (the buffer of the port was full); `other` is any other.
 */
export type LineErrorKind = 'framing' | 'parity' | 'break' | 'overrun' | 'other';

/**
 * One thing seen on the line: a frame sent, a frame received, bytes that belong to no frame, or an error of the line.
 */
export interface LineEntry {
  /** Milliseconds since 1970, by the client's clock. The sleep of the computer counts. */
  readonly time: number;
  /** `out`: to the timer. `in`: from the timer, or an error of the line. */
  readonly direction: 'out' | 'in';
  /** The bytes as they went or came. Empty for an error of the line. */
  readonly bytes: Bytes;
  /** Null for bytes that belong to no frame, and for an error of the line. */
  readonly frame: Frame | null;
  /** Why the bytes belong to no frame; null for anything else. */
  readonly rejected: RejectionReason | null;
  /** The error that the port reported; null for anything else. */
  readonly error: LineErrorKind | null;
}

/** The names of the DOMExceptions after which Web Serial puts a new stream in place of the failed one. */
const KINDS: ReadonlyMap<unknown, LineErrorKind> = new Map([
  ['FramingError', 'framing'],
  ['ParityError', 'parity'],
  ['BreakError', 'break'],
  ['BufferOverrunError', 'overrun'],
]);

/** The kind of line error that a failed stream stands for. */
export function lineErrorKind(error: unknown): LineErrorKind {
  const { name } = Object(error) as { readonly name?: unknown };
  return KINDS.get(name) ?? 'other';
}
