/**
 * What can stand between a pilot and a timer.
 * - `unsupported`: this browser has no Web Serial.
 * - `insecure`: the page was not loaded over https (or from this computer), so the browser does not offer Web Serial.
 * - `policy`: the server of the page, or the page that embeds it, forbids serial ports by its Permissions-Policy.
 * - `nothing-chosen`: the chooser was closed without a port.
 * - `not-allowed`: the browser or its administrator forbids serial ports here, or nobody clicked.
 * - `busy`: the port is there but does not open. Another program or tab holds it, the user may not use it (Linux), or
 *   the adapter has failed: the browser does not say which.
 * - `bad-settings`: the port does not accept these settings, such as a rate that the adapter does not know.
 * - `unplugged`: the port is gone.
 * - `bad-reply`: something answered, but no timer can have such an identity; `bytes` is what it said.
 * - `lost`: an open port was unplugged, or its stream failed.
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
  /** What went wrong. */
  readonly code: ConnectionErrorCode;
  /** The bytes that came in place of an answer, where they tell something; null otherwise. */
  readonly bytes: Uint8Array | null;

  /** @param message for developers; the page has its own sentence for each code. */
  constructor(code: ConnectionErrorCode, message: string, cause?: unknown, bytes: Uint8Array | null = null) {
    super(message, cause === undefined ? undefined : { cause });
    this.code = code;
    this.bytes = bytes;
  }

  /** What `structuredClone()`, `postMessage()` and `JSON` can carry. Of the error itself they keep no code. */
  toJSON(): Pick<ConnectionError, 'name' | 'code' | 'message' | 'bytes'> {
    return { ...this, message: this.message };
  }
}
