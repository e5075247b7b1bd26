import type { Clock } from '../line/index.js';
import type { Frame, FrameDecoder } from '../protocol/index.js';

/**
 * Milliseconds of silence after which a timer gives up an unfinished request, so that a damaged length does not swallow
 * the next requests.
 */
export const SILENCE = 100;

/** Reads requests from bytes as a timer does. */
export class RequestReader {
  readonly #decoder: FrameDecoder;
  readonly #clock: Clock;
  readonly #take: (frames: readonly Frame[]) => void;
  #cancelSilence: () => void = () => {};

  /** @param take called with the requests that became whole; also with none. */
  constructor(decoder: FrameDecoder, clock: Clock, take: (frames: readonly Frame[]) => void = () => {}) {
    this.#decoder = decoder;
    this.#clock = clock;
    this.#take = take;
  }

  /** Takes the next bytes from the line. */
  push(bytes: Uint8Array): void {
    this.#take(this.#decoder.push(bytes));
    this.stop();
    if (!this.#decoder.waiting) return;
    this.#cancelSilence = this.#clock.after(SILENCE, () => this.#take(this.#decoder.idle()));
  }

  /** No longer waits for silence. */
  stop(): void {
    this.#cancelSilence();
  }
}
