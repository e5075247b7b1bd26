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
 * left yet. They leave in their own time.
 */
export class Transmitter {
  readonly #cable: Cable;
  /** The standard's [[writeFatal]]: the page knows of the loss from a stream. */
  #fatal = false;
  /** The device is gone. */
  #gone = false;
  /** The next write resolves although the device is gone, as in Chromium. */
  #spared = false;
  readonly #follows: FollowsWay;
  #onEnded: (() => void)[] = [];
  #capacity = 0;
  /** How many bytes from the page have not left. */
  #held = 0;
  readonly #departures = new Set<() => void>();
  /** The standard's [[writable]]. */
  stream: WritableStream<Uint8Array> | null = null;
  #controller: WritableStreamDefaultController | null = null;
  #hasBegun = false;
  #operation: Operation | null = null;
  /** What the buffer had room for of each chunk when the page wrote it, in the order of the writes. */
  #heads: Uint8Array[] = [];
  /** How the next operation fails. */
  #failure: WriteErrorKind | null = null;

  constructor(cable: Cable, follows: FollowsWay) {
    this.#cable = cable;
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
  failNext(kind: WriteErrorKind): void {
    this.#failure = kind;
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
    const whole = bytesOf(chunk);
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
      // Of no length any more if the page detaches the buffer while this waits for room.
      while (done < Math.max(head.length, whole.length)) {
        if (this.#failed()) return;
        const room = this.#capacity - this.#held;
        if (room === 0) return;
        const piece = (done < head.length ? head : whole).slice(done, done + room);
        done += piece.length;
        this.#depart(piece);
      }
      this.#operation?.resolve();
    });
  }

  async #drain(): Promise<void> {
    const stream = this.stream;
    try {
      await this.#run(() => {
        // Nothing is left to send, so a loss does not matter: a browser says the same.
        if (this.#held === 0 && !(this.#failure && this.#failed())) this.#operation?.resolve();
      });
    } finally {
      // Also when an abort has ended the wait: the stream then ends without another call.
      if (this.stream === stream) this.#replaceStream();
    }
  }

  #abort(): Promise<void> {
    this.#discard();
    return this.#run(() => {
      if (this.#failure && this.#failed()) return;
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
      const settling =
        (settle: (reason?: never) => void) =>
        (reason?: unknown): void => {
          if (this.#operation === operation) this.#operation = null;
          settle(reason as never);
        };
      const operation: Operation = { advance, resolve: settling(resolve as () => void), reject: settling(reject) };
      this.#operation = operation;
      queueMicrotask(() => {
        if (this.#operation === operation) advance();
      });
    });
  }

  /** Fails the operation if the device is gone, or a test asked for a failure. */
  #failed(): boolean {
    const kind = this.#gone ? 'lost' : this.#failure;
    if (!kind) return false;
    if (!this.#gone) this.#failure = null;
    if (kind === 'lost') this.#gone = this.#fatal = true;
    this.#operation?.reject(streamError(kind));
    this.#replaceStream();
    return true;
  }

  /** Puts bytes on the line. They count until they have left. */
  #depart(bytes: Uint8Array): void {
    this.#held += bytes.length;
    const at = this.#cable.sendToDevice(bytes);
    const cancel = this.#cable.clock.after(at - this.#cable.clock.now(), () => {
      this.#departures.delete(cancel);
      this.#held -= bytes.length;
      this.#operation?.advance();
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
    this.#held = 0;
  }
}
