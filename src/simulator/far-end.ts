import type { Bytes } from '../protocol/index.js';

/** The far end of a pair of byte streams, as a timer has it: takes what is written, gives what it sends, can be cut. */
export class FarEnd {
  readonly readable: ReadableStream<Bytes>;
  readonly writable: WritableStream<Uint8Array>;
  #controller: ReadableStreamDefaultController<Bytes> | undefined;
  #isCut = false;

  /** @param receive called with the bytes that are written. */
  constructor(receive: (bytes: Uint8Array) => void) {
    this.readable = new ReadableStream<Bytes>({
      start: (controller) => {
        this.#controller = controller;
      },
      cancel: () => {
        this.#controller = undefined;
      },
    });
    this.writable = new WritableStream<Uint8Array>({
      write: (bytes) => {
        if (this.#isCut) throw new Error('The line to the timer is cut.');
        receive(bytes);
      },
    });
  }

  /** Gives bytes to whoever reads. */
  send(bytes: Bytes): void {
    this.#controller?.enqueue(bytes);
  }

  /** From now on reading fails with this reason, and writing fails, too. */
  cut(reason: unknown): void {
    this.#isCut = true;
    this.#controller?.error(reason);
    this.#controller = undefined;
  }
}
