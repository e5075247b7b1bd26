/**
 * The door by which bytes come in and go out: the shape that a SerialPort, a WebSocketStream, Node's `Duplex.toWeb` and
 * the virtual timer share. A SerialPort puts a new stream in place of one that failed with a framing error, and
 * null when it is closed or gone, so both are taken afresh each time they are needed.
 */
export interface BytePort {
  readonly readable: ReadableStream<Uint8Array> | null;
  readonly writable: WritableStream<Uint8Array> | null;
}
