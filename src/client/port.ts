/** As much of a `ReadableStreamDefaultReader` of bytes as the client uses. */
export interface ByteReader {
  read(): Promise<{ readonly done: boolean; readonly value?: Uint8Array | undefined }>;
  cancel(reason?: unknown): Promise<void>;
  releaseLock(): void;
}

/** As much of a `WritableStreamDefaultWriter` of bytes as the client uses. */
export interface ByteWriter {
  write(bytes: Uint8Array): Promise<void>;
  releaseLock(): void;
}

/** As much of a `ReadableStream` of bytes as the client uses. */
export interface ByteSource {
  readonly locked: boolean;
  getReader(): ByteReader;
}

/** As much of a `WritableStream` of bytes as the client uses. */
export interface ByteSink {
  readonly locked: boolean;
  getWriter(): ByteWriter;
}

/**
 * The door by which bytes come in and go out: the shape that a SerialPort, a WebSocketStream, Node's `Duplex.toWeb` and
 * the virtual timer share, whether their types are those of the DOM or of Node. A SerialPort puts a new stream in place
 * of one that failed with a framing error, and null when it is closed or gone, so both are taken afresh each time they
 * are needed.
 */
export interface BytePort {
  readonly readable: ByteSource | null;
  readonly writable: ByteSink | null;
}
