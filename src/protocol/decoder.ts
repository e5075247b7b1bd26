import { checksum, type Frame, MAX_LENGTH, MIN_LENGTH, TERMINATOR, ZEROS_NEEDED, ZEROS_SENT } from './frame.js';

/**
 * Why bytes were passed over.
 *
 * - `noise`: no header (four zeros and a length) stands in them.
 * - `length`: the length after the zeros is 1 or 2.
 * - `terminator`: the byte where the frame should end is not 45.
 * - `checksum`: the sum of command and data is another.
 * - `silence`: the line fell silent before the frame was whole.
 */
export type RejectionReason = 'noise' | 'length' | 'terminator' | 'checksum' | 'silence';

/** A run of bytes that belong to no frame. A run that spans several chunks is reported in pieces. */
export interface Rejection {
  /** Why the first header in these bytes was refused, or `noise`. */
  readonly reason: RejectionReason;
  /** The bytes as they came. Of more than five zeros before them only five are shown. */
  readonly bytes: Uint8Array;
}

export interface DecoderQuirks {
  /**
   * Takes a frame of four bytes whose checksum is the bare command byte, as the source prints it: `true` for the reply to GETLOWRPM
   * (76), or the letters for which to do so. Off unless asked for: it lets more damaged frames pass. May be switched while the
   * decoder runs.
   */
  bareChecksum?: boolean | readonly number[];
}

export interface FrameDecoderOptions {
  /** Told of all bytes that belong to no frame. */
  readonly onRejected?: ((rejection: Rejection) => void) | undefined;
  /** Told of each frame together with its bytes as they came, before `push` returns it. Of more than five zeros five are shown. */
  readonly onFrame?: ((frame: Frame, bytes: Uint8Array, bareChecksum: boolean) => void) | undefined;
  readonly quirks?: DecoderQuirks | undefined;
}

/** The longest frame without its zeros: length, 254 bytes more, terminator. */
const LONGEST = MAX_LENGTH + 1;
const NO_DATA = new Uint8Array(0);
/** The one reply for which the source prints a checksum that leaves the data out: to GETLOWRPM. */
const BARE_CHECKSUM: readonly number[] = [0x76];

/**
 * Finds frames in a stream of bytes that may be cut, damaged or noisy. No bytes make it throw.
 *
 * A frame begins with four or more zeros; the next byte that is not zero is its length. When the length, the terminator
 * or the checksum is wrong, the decoder looks again from the byte after that length, so a frame hidden behind a false
 * header is found. It holds at most one longest frame (256 bytes).
 */
export class FrameDecoder {
  readonly quirks: DecoderQuirks;
  readonly #onRejected: FrameDecoderOptions['onRejected'];
  readonly #onFrame: FrameDecoderOptions['onFrame'];
  /** A frame that is not whole yet, from its length byte on. */
  readonly #held = new Uint8Array(LONGEST);
  #heldLength = 0;
  /** Zeros directly before the next byte to be looked at, or before the held frame. */
  #zeros = 0;

  constructor(options: FrameDecoderOptions = {}) {
    this.#onRejected = options.onRejected;
    this.#onFrame = options.onFrame;
    this.quirks = options.quirks ?? {};
  }

  /** Whether a frame has begun and is not whole yet. */
  get waiting(): boolean {
    return this.#heldLength > 0;
  }

  /**
   * Takes the next bytes from the line, cut anywhere.
   * @returns the frames that became whole, in order. Their data never shares memory with `chunk`; frames that came together may lie
   * in one buffer, so whoever takes `data.buffer` has to mind `byteOffset` and `byteLength`.
   */
  push(chunk: Uint8Array): Frame[] {
    const frames: Frame[] = [];
    let at = 0;
    while (this.#heldLength > 0) {
      const missing = (this.#held[0] as number) + 1 - this.#heldLength;
      const taken = Math.min(missing, chunk.length - at);
      for (let i = 0; i < taken; i++) this.#held[this.#heldLength + i] = chunk[at + i] as number;
      this.#heldLength += taken;
      at += taken;
      if (taken < missing) return frames;
      this.#scanHeld(frames, undefined);
    }
    if (at < chunk.length) this.#scan(chunk, at, chunk.length, at, undefined, frames);
    return frames;
  }

  /**
   * The line has fallen silent: gives up the unfinished frame and looks inside what had come of it.
   * @returns the frames found there.
   */
  idle(): Frame[] {
    const frames: Frame[] = [];
    while (this.#heldLength > 0) this.#scanHeld(frames, 'silence');
    return frames;
  }

  /** Looks at the held bytes: as a whole frame, or, with a reason to give that up, only behind their first byte. */
  #scanHeld(frames: Frame[], givenUp: RejectionReason | undefined): void {
    const length = this.#heldLength;
    this.#heldLength = 0;
    if (givenUp) {
      const zeros = this.#zeros;
      this.#zeros = 0;
      this.#scan(this.#held, 1, length, 0, givenUp, frames, zeros);
    } else {
      this.#scan(this.#held, 0, length, 0, undefined, frames);
    }
  }

  /**
   * The one walk over the bytes from `at` to `end`. Each byte is looked at here once: only a frame that is not whole
   * ends the walk early, and then the rest is held.
   *
   * @param skipped where the bytes begin that belong to no frame so far; with `reason` if a header among them was refused,
   * and with the zeros before them that came in earlier chunks.
   */
  #scan(
    bytes: Uint8Array,
    from: number,
    end: number,
    skippedFrom: number,
    firstReason: RejectionReason | undefined,
    frames: Frame[],
    firstZeros = this.#zeros,
  ): void {
    let at = from;
    let zeros = this.#zeros;
    let skipped = skippedFrom;
    let skippedZeros = firstZeros;
    let reason = firstReason;
    // One copy for all frames of a chunk: an array of its own for each would cost more than finding them.
    let own: Uint8Array | undefined;
    while (at < end) {
      const length = bytes[at] as number;
      if (length === 0) {
        zeros++;
        at++;
        continue;
      }
      if (zeros < ZEROS_NEEDED) {
        zeros = 0;
        at++;
        continue;
      }
      let wrong: RejectionReason | undefined;
      if (length < MIN_LENGTH) {
        wrong = 'length';
      } else if (at + length >= end) {
        // Not whole yet. What came before its zeros belongs to no frame; the rest has to wait.
        this.#report(bytes, skipped, at, skippedZeros, zeros, reason);
        if (bytes === this.#held) bytes.copyWithin(0, at, end);
        else this.#held.set(bytes.subarray(at, end));
        this.#heldLength = end - at;
        this.#zeros = zeros;
        return;
      } else {
        wrong = this.#fault(bytes, at, length);
      }
      if (wrong) {
        reason ??= wrong;
        zeros = 0;
        at++;
        continue;
      }
      this.#report(bytes, skipped, at, skippedZeros, zeros, reason);
      if (length > MIN_LENGTH && bytes !== this.#held) own ??= bytes.slice(0, end);
      frames.push(this.#take(bytes, own, at, length, zeros));
      at += length + 1;
      zeros = 0;
      skipped = at;
      skippedZeros = 0;
      reason = undefined;
    }
    this.#report(bytes, skipped, end, skippedZeros, zeros, reason);
    this.#zeros = zeros;
  }

  /** What is wrong with the whole frame whose length byte stands at `at`; undefined if nothing is. */
  #fault(bytes: Uint8Array, at: number, length: number): RejectionReason | undefined {
    if (bytes[at + length] !== TERMINATOR) return 'terminator';
    const last = at + length - 1;
    if (sumOf(bytes, at + 1, last) === bytes[last] || this.#isBare(bytes, at, length)) return undefined;
    return 'checksum';
  }

  #isBare(bytes: Uint8Array, at: number, length: number): boolean {
    const { bareChecksum } = this.quirks;
    if (!bareChecksum || length !== MIN_LENGTH + 1) return false;
    const code = bytes[at + 1] as number;
    const letters = bareChecksum === true ? BARE_CHECKSUM : bareChecksum;
    return bytes[at + 3] === code && letters.includes(code);
  }

  #take(bytes: Uint8Array, own: Uint8Array | undefined, at: number, length: number, zeros: number): Frame {
    const code = bytes[at + 1] as number;
    let data: Uint8Array = NO_DATA;
    if (length > MIN_LENGTH) {
      data = own ? new Uint8Array(own.buffer, at + 2, length - MIN_LENGTH) : bytes.slice(at + 2, at + length - 1);
    }
    const frame: Frame = { code, data };
    if (this.#onFrame) {
      const bare = bytes[at + length - 1] !== checksum(code, data);
      this.#onFrame(frame, withZeros(zeros, bytes.subarray(at, at + length + 1)), bare);
    }
    return frame;
  }

  /**
   * Reports the bytes from `from` to `to`, less the zeros at their end, which may begin a frame. `zerosBefore` of them came in
   * earlier chunks; `zerosAfter` is the length of the run of zeros that ends at `to`.
   */
  #report(
    bytes: Uint8Array,
    from: number,
    to: number,
    zerosBefore: number,
    zerosAfter: number,
    reason: RejectionReason | undefined,
  ): void {
    const end = to - zerosAfter;
    if (!this.#onRejected || end <= from) return;
    this.#onRejected({ reason: reason ?? 'noise', bytes: withZeros(zerosBefore, bytes.subarray(from, end)) });
  }
}

/** The sum of some bytes, modulo 256: four at a time, since this is what most of the decoder's time goes to. */
function sumOf(bytes: Uint8Array, from: number, to: number): number {
  let sum = 0;
  let at = from;
  for (; at + 3 < to; at += 4) {
    sum += (bytes[at] as number) + (bytes[at + 1] as number) + (bytes[at + 2] as number) + (bytes[at + 3] as number);
  }
  for (; at < to; at++) sum += bytes[at] as number;
  return sum & 0xff;
}

function withZeros(zeros: number, bytes: Uint8Array): Uint8Array {
  const shown = Math.min(zeros, ZEROS_SENT);
  const all = new Uint8Array(shown + bytes.length);
  all.set(bytes, shown);
  return all;
}
