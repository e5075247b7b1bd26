import { CodecError, requireInteger } from './errors.js';

/**
 * Bytes that this package makes: in a buffer of their own kind, never a shared one, as `Blob`, `fetch`, `WebSocket` and
 * `crypto.subtle` ask for. From TypeScript 5.7 on it is `Uint8Array<ArrayBuffer>`, before that `Uint8Array`.
 */
export type Bytes = ReturnType<typeof Uint8Array.of>;

/**
 * The content of one frame. On the wire, five zeros (preamble and sync) and the length stand before it, the checksum
 * and the terminator 45 after it.
 */
export interface Frame<Data extends Uint8Array = Bytes> {
  /** The letter of the command, 0..255. Requests have odd letters; each reply has the next even one. */
  readonly code: number;
  /** 0 to 252 bytes. */
  readonly data: Data;
}

/** Zeros that are sent before each frame: one of preamble, four of sync. */
export const ZEROS_SENT = 5;
/** Zeros that a frame needs before it: the maker's own examples print four. */
export const ZEROS_NEEDED = 4;
/** The last byte of every frame. It may also stand inside data, so alone it does not end a frame. */
export const TERMINATOR = 0x45;
/** The smallest length. It counts itself, the command and the checksum; data adds to it. */
export const MIN_LENGTH = 3;
/** The greatest length: it is one byte. */
export const MAX_LENGTH = 255;
/** The most data bytes that a frame can carry: 252. */
export const MAX_DATA = MAX_LENGTH - MIN_LENGTH;

/** Bytes on the wire of a frame with this many bytes of data. */
export function frameSize(dataLength: number): number {
  return ZEROS_SENT + MIN_LENGTH + dataLength + 1;
}

/** The sum of command and data, modulo 256. The length does not count. */
export function checksum(code: number, data: ArrayLike<number>): number {
  let sum = code;
  for (let i = 0; i < data.length; i++) sum += data[i] as number;
  return sum & 0xff;
}

/** How a frame may differ from the usual form. */
export interface EncodeFrameOptions {
  /**
   * Sends the bare command byte in place of the checksum, as three examples of the source print it (row 5 of
   * docs/protocol.md). Default false.
   */
  readonly bareChecksum?: boolean;
}

/**
 * Wraps a command and its data: `00 00 00 00 00 LENGTH CODE DATA... CHECKSUM 45`.
 * @param code the command's letter, 0..255.
 * @param data 0 to 252 bytes.
 * @throws CodecError `not-an-integer`, `out-of-range` (code), `wrong-type` or `wrong-length` (data).
 * @example
 * ```ts
 * import { encodeFrame } from 'sidus-timer/protocol';
 *
 * const bytes = encodeFrame(0x6b); // GETSWVER
 * console.log(bytes.join(' ')); // 0 0 0 0 0 3 107 107 69
 * ```
 */
export function encodeFrame(code: number, data: ArrayLike<number> = [], options: EncodeFrameOptions = {}): Bytes {
  requireInteger(code, 'code', 0, 0xff);
  if (!Number.isInteger(data?.length)) throw new CodecError('wrong-type', 'data', 'no list of bytes');
  if (data.length < 0 || data.length > MAX_DATA) {
    throw new CodecError('wrong-length', 'data', `a frame carries at most ${MAX_DATA} bytes, not ${data.length}`, {
      max: MAX_DATA,
    });
  }
  for (let i = 0; i < data.length; i++) requireInteger(data[i], `data[${i}]`, 0, 0xff);
  const length = MIN_LENGTH + data.length;
  const bytes = new Uint8Array(frameSize(data.length));
  bytes[ZEROS_SENT] = length;
  bytes[ZEROS_SENT + 1] = code;
  bytes.set(data, ZEROS_SENT + 2);
  bytes[ZEROS_SENT + length - 1] = options.bareChecksum ? code : checksum(code, data);
  bytes[ZEROS_SENT + length] = TERMINATOR;
  return bytes;
}
