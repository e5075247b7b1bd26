import { type Bytes, checksum, type Frame, MIN_LENGTH, TERMINATOR, ZEROS_NEEDED, ZEROS_SENT } from './frame.js';

/**
 * Why bytes were skipped.
 * - `noise`: they hold no header (four zeros and a length).
 * - `length`: the length after the zeros is 1 or 2.
 * - `terminator`: the byte where the frame should end is not 45.
 * - `checksum`: the sum of command and data is wrong.
 * - `silence`: the line fell silent before the frame was whole.
 */
export type RejectionReason = 'noise' | 'length' | 'terminator' | 'checksum' | 'silence';

/** A run of bytes that belong to no frame. A run that spans several chunks is reported in pieces. */
export interface Rejection {
  /** Why the first header in these bytes was refused; `noise` when there is none. */
  readonly reason: RejectionReason;
  /** The bytes as they came. Of the zeros before them at most five are shown. */
  readonly bytes: Bytes;
}

/** How the frames of a timer may differ from the usual form. */
export interface DecoderQuirks {
  /**
   * Takes a reply to GETLOWRPM (76) of one data byte whose checksum is the bare command byte, as the source prints it.
   * A list names the letters for which to do so. Off by default, because it lets more damaged frames pass. May be
   * switched while the decoder runs.
   */
  bareChecksum?: boolean | readonly number[];
}

/** Whom a decoder tells, and what it accepts. */
export interface FrameDecoderOptions {
  /** Called with all bytes that belong to no frame. */
  readonly onRejected?: ((rejection: Rejection) => void) | undefined;
  /**
   * Called with each frame and its bytes as they came, before `push` returns the frame. Of the zeros before it at most
   * five are shown.
   */
  readonly onFrame?: ((frame: Frame, bytes: Bytes, bareChecksum: boolean) => void) | undefined;
  /** How the frames of this timer differ from the usual form. Default: not at all. */
  readonly quirks?: DecoderQuirks | undefined;
}

/**
 * Twice the longest frame, which has 256 bytes from its length byte on. It is the room for held bytes, and for their
 * sums. A frame inside another one never needs more.
 */
const ROOM = 512;
/** The longest buffer that the data of several frames share, in bytes. */
const SHARED = 4096;
const NO_DATA = new Uint8Array(0);
/** The one reply, to GETLOWRPM, for which the source prints a checksum without the data. */
const BARE_CHECKSUM: readonly number[] = [0x76];

/**
 * Finds frames in a stream of bytes that may be cut, damaged or noisy. No bytes make it throw.
 *
 * A frame begins with four or more zeros; the next byte that is not zero is its length. When length, terminator or
 * checksum is wrong, the decoder looks again from the byte after that length, and so finds a frame that a false header
 * hides. It never holds more than the longest frame, 256 bytes.
 * @example
 * ```ts
 * import { encodeFrame, FrameDecoder } from 'sidus-timer/protocol';
 *
 * const decoder = new FrameDecoder();
 * const bytes = encodeFrame(0x72, [3]);
 * console.log(decoder.push(bytes.subarray(0, 7)).length); // 0
 * console.log(decoder.push(bytes.subarray(7))[0]?.code); // 114
 * ```
 */
export class FrameDecoder {
  /** How the frames of this timer differ. May be changed while the decoder runs. */
  readonly quirks: DecoderQuirks;
  readonly #onRejected: FrameDecoderOptions['onRejected'];
  readonly #onFrame: FrameDecoderOptions['onFrame'];
  /**
   * The frame that is not whole yet, from its length byte on. With room for two, a frame that begins inside a false one
   * can mostly stay where it is. Else a stream of false headers would move all bytes for each of them.
   */
  readonly #held = new Uint8Array(ROOM);
  /**
   * Where the held frame begins, how far it has come, and where it will end.
   * No frame is held when it has come that far.
   */
  #from = 0;
  #to = 0;
  #whole = 0;
  /** Zeros directly before the next byte to look at, or before the held frame. */
  #zeros = 0;
  /**
   * Running sums of the bytes, as a ring, from the first header whose checksum was wrong up to `#summed`. The headers
   * inside its frame then need no byte added again. Only the difference of two sums means something.
   */
  readonly #sums = new Uint8Array(ROOM);
  #summed = 0;

  /** @param options whom to tell of frames and damage, and what to accept. */
  constructor(options: FrameDecoderOptions = {}) {
    this.#onRejected = options.onRejected;
    this.#onFrame = options.onFrame;
    this.quirks = options.quirks ?? {};
  }

  /** Whether a frame has begun and is not whole yet. */
  get waiting(): boolean {
    return this.#to < this.#whole;
  }

  /**
   * Takes the next bytes from the line. A chunk may begin and end anywhere.
   * @returns the frames that became whole, in order. Their data never shares memory with `chunk`. Frames that came
   * together may share one buffer of up to 4096 bytes, so use `data.byteOffset` and `data.byteLength` with
   * `data.buffer`.
   * @throws TypeError for anything but a Uint8Array, such as a text or an ArrayBuffer, in which no frame would ever be
   * found.
   */
  push(chunk: Uint8Array): Frame[] {
    // By its name: an object of another window or worker is no instance of this one's Uint8Array.
    if ((chunk as Partial<Uint8Array> | null)?.[Symbol.toStringTag] !== 'Uint8Array')
      throw new TypeError('a chunk must be a Uint8Array, such as new Uint8Array(buffer)');
    const frames: Frame[] = [];
    let at = 0;
    while (this.#to < this.#whole) {
      at = this.#fill(chunk, at, chunk.length);
      if (this.#to < this.#whole) return frames;
      this.#scan(this.#held, this.#from, this.#to, frames);
    }
    // Only counts the zeros in front: when bytes come one by one, five of the nine pushes of a short frame end here.
    let zeros = this.#zeros;
    for (; at < chunk.length && chunk[at] === 0; at++) zeros++;
    this.#zeros = zeros;
    this.#summed = 0;
    if (at < chunk.length) this.#scan(chunk, at, chunk.length, frames);
    return frames;
  }

  /**
   * Call it when the line has fallen silent. Gives up the unfinished frame and looks for frames inside its bytes.
   * @returns the frames found there.
   */
  idle(): Frame[] {
    const frames: Frame[] = [];
    while (this.#to < this.#whole) {
      this.#whole = this.#to;
      this.#scan(this.#held, this.#from, this.#to, frames, 'silence');
    }
    return frames;
  }

  /**
   * Adds to the held frame the bytes that it lacks, as far as they stand in `bytes` between `from` and `end`.
   * @returns where the remaining bytes begin.
   */
  #fill(bytes: Uint8Array, from: number, end: number): number {
    const held = this.#held;
    const until = Math.min(end, from + this.#whole - this.#to);
    let to = this.#to;
    for (let at = from; at < until; at++) held[to++] = bytes[at] as number;
    this.#to = to;
    return until;
  }

  /**
   * Walks once over the bytes from `from` to `end` and never back. A frame that is not whole ends the walk early; the
   * rest is then held.
   *
   * @param givenUp why the decoder no longer waits for the frame that begins at `from`.
   */
  #scan(bytes: Uint8Array, from: number, end: number, frames: Frame[], givenUp?: RejectionReason): void {
    const onRejected = this.#onRejected;
    let at = from;
    let zeros = givenUp ? 0 : this.#zeros;
    // Where the bytes without a frame begin, how many zeros before them came in earlier chunks, and why the first
    // header among them was refused.
    let skipped = from;
    let skippedZeros = this.#zeros;
    let reason = givenUp;
    // Many frames of a chunk share one copy: a copy for each would cost more than finding the frame. slice() does not
    // do, because on a Buffer of Node it makes no copy. A copy has at most `SHARED` bytes, so a kept frame does not
    // keep a large chunk.
    let own: ArrayBuffer | undefined;
    let ownFrom = 0;
    let ownEnd = 0;
    while (at < end) {
      const length = bytes[at] as number;
      if (length === 0) {
        const first = at++;
        while (at < end && bytes[at] === 0) at++;
        zeros += at - first;
        continue;
      }
      if (zeros >= ZEROS_NEEDED) {
        if (length >= MIN_LENGTH && at + length >= end) {
          // The frame is not whole yet. The bytes before its zeros belong to no frame; the rest has to wait.
          if (onRejected) this.#report(onRejected, bytes, skipped, at, skippedZeros, zeros, reason);
          this.#hold(bytes, at, end);
          this.#zeros = zeros;
          return;
        }
        const wrong = this.#fault(bytes, at, length);
        if (!wrong) {
          if (onRejected) this.#report(onRejected, bytes, skipped, at, skippedZeros, zeros, reason);
          let data = NO_DATA;
          if (length > MIN_LENGTH) {
            if (bytes === this.#held) {
              data = bytes.slice(at + 2, at + length - 1);
            } else {
              if (!own || at + length > ownEnd) {
                ownFrom = at;
                ownEnd = Math.min(end, at + SHARED);
                own = new Uint8Array(bytes.subarray(ownFrom, ownEnd)).buffer;
              }
              data = new Uint8Array(own, at + 2 - ownFrom, length - MIN_LENGTH);
            }
          }
          const frame = { code: bytes[at + 1] as number, data };
          this.#onFrame?.(
            frame,
            withZeros(zeros, bytes.subarray(at, at + length + 1)),
            bytes[at + length - 1] !== checksum(frame.code, data),
          );
          frames.push(frame);
          at += length + 1;
          zeros = 0;
          skipped = at;
          skippedZeros = 0;
          reason = undefined;
          continue;
        }
        reason ??= wrong;
      }
      zeros = 0;
      at++;
      // Of any four zeros in a row one stands at every fourth byte: where that byte is not zero, no four begin here.
      while (at + 3 < end && bytes[at + 3] !== 0) at += 4;
    }
    if (onRejected) this.#report(onRejected, bytes, skipped, end, skippedZeros, zeros, reason);
    this.#zeros = zeros;
  }

  /** Holds the frame that begins at `at` and is not whole at `end`. */
  #hold(bytes: Uint8Array, at: number, end: number): void {
    const size = (bytes[at] as number) + 1;
    // Bytes of a chunk never stay: the chunk ends before the frame does.
    const stays = at + size <= bytes.length;
    this.#from = stays ? at : 0;
    this.#to = stays ? end : 0;
    this.#whole = this.#from + size;
    if (stays) return;
    this.#summed = 0;
    this.#fill(bytes, at, end);
  }

  /** What is wrong with the whole frame whose length byte stands at `at`; undefined when nothing is. */
  #fault(bytes: Uint8Array, at: number, length: number): RejectionReason | undefined {
    if (length < MIN_LENGTH) return 'length';
    if (bytes[at + length] !== TERMINATOR) return 'terminator';
    return this.#isSumRight(bytes, at, at + length - 1) || this.#isBare(bytes, at, length) ? undefined : 'checksum';
  }

  /** Whether the byte at `last` is the checksum of the bytes between the length byte at `at` and itself. */
  #isSumRight(bytes: Uint8Array, at: number, last: number): boolean {
    if (at >= this.#summed) {
      const isRight = sumOf(bytes, at + 1, last) === bytes[last];
      if (!isRight) this.#addUp(bytes, at, last);
      return isRight;
    }
    this.#addUp(bytes, at, last);
    const sums = this.#sums;
    return (((sums[last % ROOM] as number) - (sums[(at + 1) % ROOM] as number)) & 0xff) === bytes[last];
  }

  /** Fills in the running sums from `from` to `to`. Sums that are there already are not worked out again. */
  #addUp(bytes: Uint8Array, from: number, to: number): void {
    const sums = this.#sums;
    let at = Math.max(from, this.#summed);
    let sum = sums[at % ROOM] as number;
    while (at < to) {
      sum += bytes[at++] as number;
      sums[at % ROOM] = sum;
    }
    this.#summed = at;
  }

  #isBare(bytes: Uint8Array, at: number, length: number): boolean {
    const { bareChecksum } = this.quirks;
    if (!bareChecksum || length !== MIN_LENGTH + 1) return false;
    const code = bytes[at + 1] as number;
    const letters = bareChecksum === true ? BARE_CHECKSUM : bareChecksum;
    return bytes[at + 3] === code && letters.includes(code);
  }

  /**
   * Reports the bytes from `from` to `to`, without the zeros at their end, which may begin a frame. `zerosBefore` of
   * them came in earlier chunks; `zerosAfter` counts the zeros that end at `to`.
   */
  #report(
    onRejected: (rejection: Rejection) => void,
    bytes: Uint8Array,
    from: number,
    to: number,
    zerosBefore: number,
    zerosAfter: number,
    reason: RejectionReason | undefined,
  ): void {
    const end = to - zerosAfter;
    if (end <= from) return;
    onRejected({ reason: reason ?? 'noise', bytes: withZeros(zerosBefore, bytes.subarray(from, end)) });
  }
}

/**
 * The sum of some bytes, modulo 256. Four at a time and from the end: the quickest simple loop, for the work that takes
 * most of the time.
 */
function sumOf(bytes: Uint8Array, from: number, to: number): number {
  let sum = 0;
  let at = to - 1;
  for (; at - 3 >= from; at -= 4) {
    sum += (bytes[at] as number) + (bytes[at - 1] as number) + (bytes[at - 2] as number) + (bytes[at - 3] as number);
  }
  for (; at >= from; at--) sum += bytes[at] as number;
  return sum & 0xff;
}

function withZeros(zeros: number, bytes: Uint8Array): Bytes {
  const shown = Math.min(zeros, ZEROS_SENT);
  const all = new Uint8Array(shown + bytes.length);
  all.set(bytes, shown);
  return all;
}
