// The law of docs/protocol.md twice, in its plainest forms, with nothing of the package in it: what the decoder is held
// to. Plain JavaScript, so that scripts can use it as well as tests.

/** @typedef {{ code: number, data: Uint8Array }} Frame */

/**
 * The frames of a stream that is there as a whole and after which the line falls silent, read off by the one sentence
 * of the law.
 * @param {Uint8Array} stream
 * @returns {Frame[]}
 */
export function framesOf(stream) {
  /** @type {Frame[]} */
  const frames = [];
  let begin = 0;
  for (let at = 0; at < stream.length; at++) {
    if (at - begin < 4 || !isRight(stream, at)) continue;
    if (stream[at - 4] !== 0 || stream[at - 3] !== 0 || stream[at - 2] !== 0 || stream[at - 1] !== 0) continue;
    const end = at + byteAt(stream, at);
    frames.push({ code: byteAt(stream, at + 1), data: stream.slice(at + 2, end - 1) });
    begin = end + 1;
    at = end;
  }
  return frames;
}

/**
 * Whether the frame whose length byte stands at `at` has a right length, terminator and sum.
 * @param {Uint8Array} bytes
 * @param {number} at
 */
export function isRight(bytes, at) {
  const length = byteAt(bytes, at);
  if (length < 3 || at + length >= bytes.length || bytes[at + length] !== 0x45) return false;
  let sum = 0;
  for (let i = at + 1; i < at + length - 1; i++) sum += byteAt(bytes, i);
  return sum % 256 === bytes[at + length - 1];
}

/**
 * @param {Uint8Array} bytes
 * @param {number} at
 */
function byteAt(bytes, at) {
  return /** @type {number} */ (bytes[at]);
}

/** The program of docs/protocol.md, line by line: slow, and able to be told of silence at any time. */
export class PageDecoder {
  /** @type {number[]} */
  #held = [];
  #zeros = 0;

  /**
   * @param {Iterable<number>} bytes
   * @returns {Frame[]}
   */
  push(bytes) {
    /** @type {Frame[]} */
    const frames = [];
    let queue = [...bytes];
    let next = 0;
    for (;;) {
      const [length = 0] = this.#held;
      if (this.#held.length === 0) {
        if (next === queue.length) return frames;
        const byte = /** @type {number} */ (queue[next++]);
        if (byte === 0) this.#zeros++;
        else if (this.#zeros >= 4 && byte >= 3) this.#held = [byte];
        else this.#zeros = 0;
      } else if (this.#held.length < length + 1) {
        if (next === queue.length) return frames;
        this.#held.push(/** @type {number} */ (queue[next++]));
      } else if (isRight(Uint8Array.from(this.#held), 0)) {
        const [, code = 0, ...rest] = this.#held;
        frames.push({ code, data: Uint8Array.from(rest.slice(0, -2)) });
        this.#held = [];
        this.#zeros = 0;
      } else {
        queue = [...this.#held.slice(1), ...queue.slice(next)];
        next = 0;
        this.#held = [];
        this.#zeros = 0;
      }
    }
  }

  /** @returns {Frame[]} */
  idle() {
    /** @type {Frame[]} */
    const frames = [];
    while (this.#held.length > 0) {
      const rest = this.#held.slice(1);
      this.#held = [];
      this.#zeros = 0;
      frames.push(...this.push(rest));
    }
    return frames;
  }
}
