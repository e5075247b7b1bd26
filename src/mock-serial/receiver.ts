import type { Bytes } from '../line/index.js';
import { streamError } from './errors.js';
import type { ReadErrorKind } from './types.js';

type Item = Bytes | ReadErrorKind;
/** Called with whether all bytes before it are in the buffer. */
type Mark = (kept: boolean) => void;

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
  #patient = false;
  #size = 0;
  /** The content of the buffer, in the order in which it came. */
  #queue: Item[] = [];
  /** Bytes that wait for room, when the device is patient. */
  #backlog: (Item | Mark)[] = [];
  /** How many bytes were lost before the last mark. */
  #lostBefore = 0;
  /** The standard's [[readable]]. */
  stream: ReadableStream<Bytes> | null = null;
  #controller: ReadableByteStreamController | null = null;
  /** Whether the page waits for a read. */
  #wanted = false;
  readonly #onCancel: () => void;

  /** @param onCancel called when the page cancels the stream, so that nothing comes that was sent before. */
  constructor(onCancel: () => void) {
    this.#onCancel = onCancel;
  }

  get full(): boolean {
    return this.#size >= this.#capacity;
  }

  /**
   * @param patient whether the device waits for room. Otherwise bytes are lost.
   * @param keeps whether the stream and the bytes of before come back, without the loss that ended them.
   */
  open(capacity: number, patient: boolean, keeps = false): void {
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
    this.#discard();
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
    const room = this.#capacity - this.#size;
    // A page that waits takes bytes as they come: a burst on a line that takes no time does not overrun it.
    if (this.#patient || this.#wanted || bytes.length <= room) this.#backlog.push(bytes);
    else this.#backlog.push(bytes.slice(0, room), ...this.#overrun(bytes.length - room));
    this.#refill();
    this.#serve();
  }

  fail(kind: ReadErrorKind): void {
    if (!this.#open || this.#over) return;
    if (kind === 'lost') {
      this.#over = true;
      this.#dropBacklog();
    }
    this.#backlog.push(kind);
    this.#refill();
    this.#serve();
  }

  /** Calls `tell` once it is known whether all bytes since the last mark are in the buffer. */
  mark(tell: Mark): void {
    const lost = this.lost - this.#lostBefore;
    this.#lostBefore = this.lost;
    if (lost > 0) tell(false);
    else if (this.#backlog.length > 0) this.#backlog.push(tell);
    else tell(true);
  }

  #overrun(bytes: number): ReadErrorKind[] {
    this.lost += bytes;
    return this.#queue.at(-1) === 'overrun' ? [] : ['overrun'];
  }

  /** Moves bytes from the backlog to the buffer while there is room. Errors take no room. */
  #refill(): void {
    for (let next = this.#backlog.shift(); next !== undefined; next = this.#backlog.shift()) {
      if (typeof next === 'function') {
        next(true);
        continue;
      }
      const room = this.#capacity - this.#size;
      if (typeof next !== 'string' && next.length > room) {
        this.#backlog.unshift(next.slice(room));
        if (room === 0) return;
        next = next.slice(0, room);
      }
      if (next.length === 0) continue;
      this.#queue.push(next);
      if (typeof next !== 'string') this.#size += next.length;
    }
  }

  #serve(): void {
    const controller = this.#controller;
    const next = this.#queue[0];
    if (!controller || !this.#wanted || next === undefined) return;
    this.#wanted = false;
    if (typeof next === 'string') {
      if (next === 'lost') this.#fatal = true;
      this.#queue.shift();
      controller.error(streamError(next));
      this.#replaceStream();
      return;
    }
    const view = controller.byobRequest?.view;
    const length = Math.min(next.length, view?.byteLength ?? next.length);
    if (length === next.length) this.#queue.shift();
    else this.#queue[0] = next.slice(length);
    this.#size -= length;
    this.#refill();
    if (view) {
      new Uint8Array(view.buffer, view.byteOffset, view.byteLength).set(next.subarray(0, length));
      controller.byobRequest?.respond(length);
    } else {
      controller.enqueue(next as Bytes);
    }
  }

  /** The standard's "handle closing the readable stream", without the part that `close()` waits for. */
  #replaceStream(): void {
    this.stream = null;
    this.#controller = null;
    this.#wanted = false;
  }

  async #cancel(): Promise<void> {
    const stream = this.stream;
    // The page cannot read of the loss any more, and yet there is no new stream after it.
    if (this.#over) this.#fatal = true;
    this.#discard();
    this.#onCancel();
    await null;
    if (this.stream === stream) this.#replaceStream();
  }

  #discard(): void {
    this.#queue = [];
    this.#dropBacklog();
    this.#size = 0;
  }

  /** Bytes that were held back never get into the buffer. */
  #dropBacklog(): void {
    const dropped = this.#backlog;
    this.#backlog = [];
    for (const each of dropped) {
      if (typeof each === 'function') each(false);
      else if (typeof each !== 'string') this.lost += each.length;
    }
    this.#lostBefore = this.lost;
  }
}
