import type { Cable } from './cable.js';
import { streamError } from './errors.js';
import type { FollowsWay, WriteErrorKind } from './types.js';

/** A write, close or abort of the stream in progress. There is never more than one. */
interface Operation {
  /** Goes on as far as there is room. Settles the operation when nothing is left to do. */
  readonly advance: () => void;
  readonly resolve: () => void;
  readonly reject: (reason: unknown) => void;
}

/** Gives the length of an ArrayBuffer from any realm. Throws for anything else, also for shared memory. */
const lengthOf = Object.getOwnPropertyDescriptor(ArrayBuffer.prototype, 'byteLength')?.get as (this: unknown) => number;

/** The bytes that a chunk holds now; none once its buffer is detached, as in Web IDL. @throws TypeError */
function bytesOf(chunk: unknown): Uint8Array {
  const buffer = ArrayBuffer.isView(chunk) ? chunk.buffer : chunk;
  let length: number;
  try {
    length = lengthOf.call(buffer);
  } catch {
    throw new TypeError('The chunk must be an ArrayBuffer or a view of one.');
  }
  if ((buffer as { readonly resizable?: boolean }).resizable)
    throw new TypeError('The chunk must not be a resizable ArrayBuffer or a view of one.');
  if (length === 0) return new Uint8Array();
  return ArrayBuffer.isView(chunk)
    ? new Uint8Array(chunk.buffer, chunk.byteOffset, chunk.byteLength)
    : new Uint8Array(buffer as ArrayBuffer);
}

/**
 * The writing side of a port: the stream that takes the page's bytes, and a buffer of `bufferSize` bytes that have not
 * left yet. On a free cable they leave in their own time. On any other they leave when the device reads them.
 */
export class Transmitter {
  readonly #cable: Cable;
  readonly #deviceWaits: () => boolean;
  /** The standard's [[writeFatal]]: the page knows of the loss from a stream. */
  #fatal = false;
  /** The device is gone. */
  #gone = false;
  /** The next write resolves although the device is gone, as in Chromium. */
  #spared = false;
  readonly #follows: FollowsWay;
  #onEnded: (() => void)[] = [];
  #capacity = 0;
  /** Bytes from the page that have not left: those in `#waiting`, and on a free cable those on the wire. */
  #held = 0;
  #waiting: Uint8Array[] = [];
  readonly #departures = new Set<() => void>();
  /** The standard's [[writable]]. */
  stream: WritableStream<Uint8Array> | null = null;
  #controller: WritableStreamDefaultController | null = null;
  #hasBegun = false;
  #operation: Operation | null = null;
  /** What the buffer had room for of each chunk when the page wrote it, in the order of the writes. */
  #heads: Uint8Array[] = [];
  #failure: { readonly error: WriteErrorKind | Error; after: number } | null = null;

  /** @param deviceWaits whether the device waits for bytes that it has not been sent. */
  constructor(cable: Cable, deviceWaits: () => boolean, follows: FollowsWay) {
    this.#cable = cable;
    this.#deviceWaits = deviceWaits;
    this.#follows = follows;
  }

  /** Settles when there is no stream any more: an operation or the loss of the device has ended it. */
  get ended(): Promise<void> {
    if (!this.stream) return Promise.resolve();
    return new Promise((resolve) => this.#onEnded.push(resolve));
  }

  open(capacity: number): void {
    this.#fatal = false;
    this.#gone = false;
    this.#capacity = capacity;
  }

  /** Forgets the stream and all bytes that have not left. */
  close(): void {
    this.#discard();
    this.#replaceStream();
  }

  /** A fresh stream, unless a fatal error forbids it. */
  createStream(): WritableStream<Uint8Array> | null {
    if (this.#fatal) return null;
    this.#heads = [];
    this.stream = new WritableStream<Uint8Array>(
      {
        start: (controller) => {
          this.#controller = controller;
          this.#hasBegun = false;
          queueMicrotask(() => {
            this.#hasBegun = true;
          });
          controller.signal.addEventListener('abort', () => this.#operation?.reject(controller.signal.reason));
        },
        write: (chunk) => this.#write(chunk),
        close: () => this.#drain(),
        abort: () => this.#abort(),
      },
      { highWaterMark: this.#capacity, size: (chunk) => this.#sizeOf(chunk) },
    );
    return this.stream;
  }

  /** See `MockDevice.failNextWrite`. */
  failNext(error: WriteErrorKind | Error, after: number): void {
    this.#failure = { error, after };
  }

  /** The device waits for bytes. */
  pull(): void {
    this.#pump();
    this.#operation?.advance();
  }

  /** The device is gone. A stream that nobody uses notices it at its next use. */
  lose(): void {
    this.#gone = true;
    this.#discard();
    if (this.#operation) this.#failed();
    else this.#spared = this.#follows('firstLostWriteResolves');
  }

  /** Fails the stream at once. */
  abandon(): void {
    const lost = streamError('lost');
    if (this.#operation) this.#operation.reject(lost);
    else this.#controller?.error(lost);
  }

  /**
   * The stream asks for the size inside the page's `write()`. So the bytes for which there is room are copied here,
   * once the stream has begun: the page may use its array again at once. Not ByteLengthQueuingStrategy: a chunk of the
   * wrong type must reach the standard's own error.
   */
  #sizeOf(chunk: unknown): number {
    let bytes: Uint8Array = new Uint8Array();
    try {
      bytes = bytesOf(chunk);
    } catch {}
    const isNext = this.#hasBegun && this.#heads.length === 0 && !this.#operation;
    this.#heads.push(bytes.slice(0, isNext ? this.#capacity - this.#held : 0));
    return bytes.length;
  }

  async #write(chunk: unknown): Promise<void> {
    const head = this.#heads.shift() as Uint8Array;
    bytesOf(chunk);
    if (this.#spared) {
      this.#spared = false;
      if (!this.#follows('lostWriteEndsStream')) return;
      this.#fatal = true;
      queueMicrotask(() => {
        this.abandon();
        this.#replaceStream();
      });
      return;
    }
    let done = 0;
    await this.#run(() => {
      // Read afresh each time: the page may detach the buffer while this waits for room.
      const rest = (): Uint8Array => (done < head.length ? head : bytesOf(chunk));
      for (let bytes = rest(); done < bytes.length; bytes = rest()) {
        if (this.#failed()) return;
        const room = Math.min(this.#capacity - this.#held, this.#failure?.after ?? Number.POSITIVE_INFINITY);
        if (room === 0) return;
        const piece = bytes.slice(done, done + room);
        done += piece.length;
        if (this.#failure) this.#failure.after -= piece.length;
        this.#waiting.push(piece);
        this.#held += piece.length;
        this.#pump();
      }
      this.#operation?.resolve();
    });
  }

  async #drain(): Promise<void> {
    const stream = this.stream;
    try {
      await this.#run(() => {
        // Nothing is left to send, so a loss does not matter: a browser says the same.
        if (this.#held === 0 && !(this.#failure?.after === 0 && this.#failed())) this.#operation?.resolve();
      });
    } finally {
      // Also when an abort has ended the wait: the stream then ends without another call.
      if (this.stream === stream) this.#replaceStream();
    }
  }

  #abort(): Promise<void> {
    this.#discard();
    return this.#run(() => {
      if (this.#failure?.after === 0 && this.#failed()) return;
      this.#operation?.resolve();
      this.#replaceStream();
    });
  }

  /**
   * Begins the operation only after the stream has gone on, like the standard's steps in parallel:
   * an abort may come first.
   */
  #run(advance: () => void): Promise<void> {
    return new Promise((resolve, reject) => {
      const settle = <Reason extends unknown[]>(by: (...reason: Reason) => void, ...reason: Reason): void => {
        if (this.#operation === operation) this.#operation = null;
        by(...reason);
      };
      const operation: Operation = {
        advance,
        resolve: () => settle(resolve),
        reject: (reason) => settle(reject, reason),
      };
      this.#operation = operation;
      queueMicrotask(() => {
        if (this.#operation === operation) advance();
      });
    });
  }

  /** Fails the operation if the device is gone, or a test asked for a failure. */
  #failed(): boolean {
    if (!this.#gone && this.#failure?.after !== 0) return false;
    const error = this.#gone ? 'lost' : (this.#failure?.error as WriteErrorKind | Error);
    if (!this.#gone) this.#failure = null;
    if (error === 'lost') {
      this.#gone = true;
      this.#fatal = true;
    }
    this.#fail(typeof error === 'string' ? streamError(error) : error);
    return true;
  }

  #fail(error: Error): void {
    this.#operation?.reject(error);
    this.#replaceStream();
  }

  /** Moves bytes from the buffer to the line: on a free cable all, on any other a chunk for each read of the device. */
  #pump(): void {
    while (this.#waiting.length > 0) {
      if (!this.#cable.free && (this.#departures.size > 0 || !this.#deviceWaits())) return;
      const bytes = this.#waiting.shift() as Uint8Array;
      this.#depart(bytes, this.#cable.sendToDevice(bytes));
    }
  }

  #depart(bytes: Uint8Array, at: number): void {
    const cancel = this.#cable.clock.after(at - this.#cable.clock.now(), () => {
      this.#departures.delete(cancel);
      this.#held -= bytes.length;
      this.pull();
    });
    this.#departures.add(cancel);
  }

  /** The standard's "handle closing the writable stream", without the part that `close()` waits for. */
  #replaceStream(): void {
    this.stream = null;
    this.#controller = null;
    const ended = this.#onEnded;
    this.#onEnded = [];
    for (const resolve of ended) resolve();
  }

  #discard(): void {
    for (const cancel of this.#departures) cancel();
    if (this.#departures.size > 0) this.#cable.dropToDevice();
    this.#departures.clear();
    this.#waiting = [];
    this.#held = 0;
  }
}
