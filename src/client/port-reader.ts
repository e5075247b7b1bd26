import { type LineErrorKind, lineErrorKind } from './log.js';
import type { BytePort, ByteReader, ByteSource } from './port.js';

export interface PortReaderOptions {
  readonly onBytes: (bytes: Uint8Array) => void;
  /** The stream failed with an error of the line, and there is a new one: reading goes on. */
  readonly onLineError: (kind: LineErrorKind) => void;
  /** Nothing more can be read. `cause` is what the stream failed with; undefined when it ended. */
  readonly onEnd: (cause: unknown) => void;
}

/**
 * Reads what a port gives until its stream ends, fails for good or is let go of. A SerialPort puts a new stream in the
 * place of one that failed with a framing, parity, break or overrun error: that one is taken, and reading goes on.
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

  /** Begins to read; harmless when it has begun. */
  start(): void {
    const { onEnd } = this.#options;
    this.#reading ??= this.#read().then(() => onEnd(undefined), onEnd);
  }

  /** Lets go of the stream. */
  async stop(): Promise<void> {
    this.#stopped = true;
    // A stream that has failed refuses to be cancelled; its lock is released anyway.
    await this.#reader?.cancel().catch(() => {});
    await this.#reading;
  }

  /** @throws what the stream failed with when there is no new one. */
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
