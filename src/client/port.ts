/** The part of a `ReadableStreamDefaultReader` of bytes that the client uses. */
export interface ByteReader {
  /** Waits for the next bytes. `done` once the stream has ended. */
  read(): Promise<{ readonly done: boolean; readonly value?: Uint8Array | undefined }>;
  /** Ends the stream. */
  cancel(reason?: unknown): Promise<void>;
  /** Leaves the stream to other readers. */
  releaseLock(): void;
}

/** The part of a `WritableStreamDefaultWriter` of bytes that the client uses. */
export interface ByteWriter {
  /** Sends bytes. Resolves once the stream has taken them. */
  write(bytes: Uint8Array): Promise<void>;
  /** Leaves the stream to other writers. */
  releaseLock(): void;
}

/** The part of a `ReadableStream` of bytes that the client uses. */
export interface ByteSource {
  /** Whether somebody has a reader. */
  readonly locked: boolean;
  /** Locks the stream. */
  getReader(): ByteReader;
}

/** The part of a `WritableStream` of bytes that the client uses. */
export interface ByteSink {
  /** Whether somebody has a writer. */
  readonly locked: boolean;
  /** Locks the stream. */
  getWriter(): ByteWriter;
}

/**
 * Where bytes come in and go out. A SerialPort, a WebSocketStream, Node's `Duplex.toWeb` and the virtual timer all have
 * this shape, with the types of the DOM or of Node. After a framing error a SerialPort has a new stream; it has null
 * when it is closed or gone. So the client reads both properties afresh each time.
 */
export interface BytePort {
  readonly readable: ByteSource | null;
  readonly writable: ByteSink | null;
}

/**
 * Makes sure that this is a port, open or closed.
 * @throws TypeError that names the usual mistakes.
 */
export function requirePort(port: BytePort): void {
  const isStream = (stream: unknown, method: string): boolean =>
    stream === null || typeof (stream as Readonly<Record<string, unknown>> | undefined)?.[method] === 'function';
  const { readable, writable } = (port ?? {}) as Partial<BytePort>;
  if (isStream(readable, 'getReader') && isStream(writable, 'getWriter')) return;
  // The streams of Node have properties of the same names, which are no streams.
  const hint = typeof readable === 'boolean' ? ': make one of a stream of Node with Duplex.toWeb(stream)' : '';
  throw new TypeError(`a port must have a readable and a writable stream of bytes${hint}`);
}
