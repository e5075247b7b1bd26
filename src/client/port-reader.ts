import { type LineErrorKind, lineErrorKind } from './log.js';
import type { BytePort, ByteReader, ByteSource } from './port.js';

export interface PortReaderOptions {
  readonly onBytes: (bytes: Uint8Array) => void;
  /** The stream failed with an error of the line. A new one is there, and reading goes on. */
  readonly onLineError: (kind: LineErrorKind) => void;
  /** Nothing more can be read. `cause` is what the stream failed with; undefined when it ended. */
  readonly onEnd: (cause: unknown) => void;
}

/**
 * Reads from a port until its stream ends or fails for good, or the reader stops. After a framing, parity, break or
 * overrun error a SerialPort has a new stream: reading goes on with that one.
 */
export class PortReader {
  readonly #port: BytePort;
  readonly #options: PortReaderOptions;
  #reader: ByteReader | undefined;
  #reading: Promise<void> | undefined;
  #stopped = false;

  constructor(port: BytePort, options: PortReaderOptions) {
    this.#port = port;
    this.#options = options;
  }

  /** Whether it has begun to read. */
  get started(): boolean {
    return this.#reading !== undefined;
  }

  /** Begins to read. Does no harm when it has begun already. */
  start(): void {
    const { onEnd } = this.#options;
    this.#reading ??= this.#read().then(() => onEnd(undefined), onEnd);
  }

  /** Stops, and releases the stream. What comes later is for the next reader. */
  async stop(): Promise<void> {
    this.#stopped = true;
    const reader = this.#reader;
    try {
      reader?.releaseLock();
    } catch {
      // An older browser keeps the lock while a read waits. A SerialPort has a new stream after that.
      await reader?.cancel().catch(() => {});
    }
    await this.#reading;
  }

  /** @throws what the stream failed with, when no new stream is there. */
  async #read(): Promise<void> {
    let failed: ByteSource | undefined;
    let cause: unknown;
    while (!this.#stopped) {
      const { readable } = this.#port;
      if (!readable || readable === failed) throw cause;
      if (failed) this.#options.onLineError(lineErrorKind(cause));
      const reader = readable.getReader();
      this.#reader = reader;
      try {
        for (;;) {
          const { value } = await reader.read();
          if (!value) return;
          this.#options.onBytes(value);
        }
      } catch (error) {
        failed = readable;
        cause = error;
      } finally {
        reader.releaseLock();
      }
    }
  }
}
