import type { Clock } from '../line/index.js';
import type { FrameDecoder } from '../protocol/index.js';

/**
 * Milliseconds of silence after which a timer gives up an unfinished request, so that a damaged length does not swallow
 * the next requests.
 */
export const SILENCE = 100;

/** Reads requests from bytes as a timer does. The decoder tells of each. */
export class RequestReader {
  readonly #decoder: FrameDecoder;
  readonly #clock: Clock;
  #cancelSilence: () => void = () => {};

  constructor(decoder: FrameDecoder, clock: Clock) {
    this.#decoder = decoder;
    this.#clock = clock;
  }

  /** Takes the next bytes from the line. */
  push(bytes: Uint8Array): void {
    this.#decoder.push(bytes);
    this.#cancelSilence();
    if (this.#decoder.waiting) this.#cancelSilence = this.#clock.after(SILENCE, () => this.#decoder.idle());
  }
}
