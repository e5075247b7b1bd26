import type { Bytes } from '../line/index.js';
import { streamError } from './errors.js';
import type { ReadErrorKind } from './types.js';

/**
 * The reading side of a port: a buffer of `bufferSize` bytes, and the stream that hands them to the page. The stream
 * itself holds nothing (high-water mark 0), so an error never overtakes a byte that came before it.
 */
export class Receiver {
  /** Bytes that came and can never be read: the port was closed, the device lost, or the buffer full. */
  lost = 0;
  #open = false;
  /** The standard's [[readFatal]]: the page knows of the loss from a stream. */
  #fatal = false;
  /** Nothing comes any more. Bytes that have arrived can still be read. */
  #over = false;
  #capacity = 0;
  /** Whether the device waits for room. Its bytes wait here, too. */
  #patient = false;
  /** What the page has not read, in the order in which it came. */
  #queue: (Bytes | ReadErrorKind)[] = [];
  /** The standard's [[readable]]. */
  stream: ReadableStream<Bytes> | null = null;
  #controller: ReadableByteStreamController | null = null;
  /** Whether the page waits for a read. */
  #wanted = false;

  /**
   * @param patient whether the device waits for room. Otherwise bytes are lost.
   * @param keeps whether the stream and the bytes of before come back, without the loss that ended them.
   */
  open(capacity: number, patient: boolean, keeps: boolean): void {
    if (!keeps) this.close();
    this.#queue = this.#queue.filter((item) => item !== 'lost');
    this.#open = true;
    this.#fatal = false;
    this.#over = false;
    this.#capacity = capacity;
    this.#patient = patient;
  }

  /** Forgets the stream and the content of the buffer. */
  close(): void {
    this.#open = false;
    this.#queue = [];
    this.#replaceStream();
  }

  /** A fresh stream, unless a fatal error forbids it. */
  createStream(): ReadableStream<Bytes> | null {
    if (this.#fatal) return null;
    const source: UnderlyingByteSource = {
      type: 'bytes',
      start: (controller) => {
        this.#controller = controller;
      },
      pull: () => {
        this.#wanted = true;
        this.#serve();
      },
      cancel: () => this.#cancel(),
    };
    this.stream = new ReadableStream(source, { highWaterMark: 0 });
    return this.stream;
  }

  push(bytes: Bytes): void {
    if (!this.#open || this.#over) {
      this.lost += bytes.length;
      return;
    }
    // A page that waits takes bytes as they come: a burst on a line that takes no time does not overrun it.
    const room = this.#patient || this.#wanted ? bytes.length : Math.max(0, this.#capacity - this.#held);
    if (room > 0) this.#queue.push(bytes.slice(0, room));
    if (room < bytes.length) {
      this.lost += bytes.length - room;
      if (this.#queue.at(-1) !== 'overrun') this.#queue.push('overrun');
    }
    this.#serve();
  }

  fail(kind: ReadErrorKind): void {
    if (!this.#open || this.#over) return;
    this.#over = kind === 'lost';
    this.#queue.push(kind);
    this.#serve();
  }

  get #held(): number {
    return this.#queue.reduce((sum, item) => sum + (typeof item === 'string' ? 0 : item.length), 0);
  }

  #serve(): void {
    const controller = this.#controller;
    if (!controller || !this.#wanted) return;
    const next = this.#queue.shift();
    if (next === undefined) return;
    this.#wanted = false;
    if (typeof next === 'string') {
      if (next === 'lost') this.#fatal = true;
      controller.error(streamError(next));
      this.#replaceStream();
      return;
    }
    const view = controller.byobRequest?.view;
    const length = Math.min(next.length, view?.byteLength ?? this.#capacity);
    if (length < next.length) this.#queue.unshift(next.slice(length));
    if (view) {
      new Uint8Array(view.buffer, view.byteOffset, view.byteLength).set(next.subarray(0, length));
      controller.byobRequest?.respond(length);
    } else {
      controller.enqueue(next.slice(0, length));
    }
  }

  /** The standard's "handle closing the readable stream", without the part that `close()` waits for. */
  #replaceStream(): void {
    this.stream = null;
    this.#controller = null;
    this.#wanted = false;
  }

  async #cancel(): Promise<void> {
    const { stream } = this;
    // The page cannot read of the loss any more, and yet there is no new stream after it.
    if (this.#over) this.#fatal = true;
    this.#queue = [];
    await null;
    if (this.stream === stream) this.#replaceStream();
  }
}
