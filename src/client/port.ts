/** The part of a `ReadableStreamDefaultReader` of bytes that the client uses. */
export interface ByteReader {
  read(): Promise<{ readonly done: boolean; readonly value?: Uint8Array | undefined }>;
  cancel(reason?: unknown): Promise<void>;
  releaseLock(): void;
}

/** The part of a `WritableStreamDefaultWriter` of bytes that the client uses. */
export interface ByteWriter {
  write(bytes: Uint8Array): Promise<void>;
  releaseLock(): void;
}

/** The part of a `ReadableStream` of bytes that the client uses. */
export interface ByteSource {
  readonly locked: boolean;
  getReader(): ByteReader;
}

/** The part of a `WritableStream` of bytes that the client uses. */
export interface ByteSink {
  readonly locked: boolean;
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
