/**
 * What can stand between a pilot and a timer.
 *
 * - `unsupported`: this browser has no Web Serial.
 * - `insecure`: the page was not loaded over https (or from this machine), so the browser does not give Web Serial.
 * - `policy`: the server of the page, or the page it is embedded in, forbids serial ports by its Permissions-Policy.
 * - `nothing-chosen`: the chooser was closed without a port.
 * - `not-allowed`: the browser or its administrator forbids serial ports here, or nobody clicked.
 * - `busy`: the port is there and cannot be opened. Another program or tab holds it, on Linux the user may not use it,
 *   or the adapter has failed: the browser does not tell which.
 * - `bad-settings`: the port does not take these settings, such as a rate that the adapter does not know.
 * - `unplugged`: the port is gone.
 * - `bad-reply`: something answered, and what it said of itself cannot be; `bytes` is what it said.
 * - `lost`: an open port was unplugged or its stream failed.
 */
export type ConnectionErrorCode =
  | 'unsupported'
  | 'insecure'
  | 'policy'
  | 'nothing-chosen'
  | 'not-allowed'
  | 'busy'
  | 'bad-settings'
  | 'unplugged'
  | 'bad-reply'
  | 'lost';

/** The one error of this room. Its message is for developers; `cause` is what the browser or the client said. */
export class ConnectionError extends Error {
  override readonly name = 'ConnectionError';
  readonly code: ConnectionErrorCode;
  /** What came in place of an answer, where that tells something. */
  readonly bytes: Uint8Array | null;

  constructor(code: ConnectionErrorCode, message: string, cause?: unknown, bytes: Uint8Array | null = null) {
    super(message, cause === undefined ? undefined : { cause });
    this.code = code;
    this.bytes = bytes;
  }
}
