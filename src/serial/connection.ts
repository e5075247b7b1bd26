import { type LineEntry, TimerClient, TimerError } from '../client/index.js';
import { type Clock, realClock } from '../line/index.js';
import type { Identity } from '../protocol/index.js';
import { ConnectionError } from './errors.js';
import type { SerialPortLike } from './types.js';

export interface ConnectOptions {
  /** Bits a second. Default 9600, 8 data bits, no parity, 1 stop bit: see the protocol page on the speed of the line. */
  readonly baudRate?: number;
  /** Default: the real clock. */
  readonly clock?: Clock;
  readonly signal?: AbortSignal;
  /** Told of everything on the line. */
  readonly onLine?: (entry: LineEntry) => void;
}

/** The browser's own default of 255 bytes overflows when the page is busy for a moment. */
const BUFFER_SIZE = 16 * 1024;

/** An open port with a timer behind it that has said what it is. */
export class TimerConnection {
  readonly client: TimerClient;
  readonly identity: Identity;
  /** Settles when the port is unplugged or its stream fails, with ConnectionError `lost`; never after {@link close}. */
  readonly lost: Promise<ConnectionError>;
  readonly #port: OpenPort;

  /** Use {@link connect}. */
  constructor(client: TimerClient, identity: Identity, port: OpenPort) {
    this.client = client;
    this.identity = identity;
    this.lost = port.lost;
    this.#port = port;
  }

  /** Lets the request under way end, releases the streams and closes the port. Never throws: a port that is gone is closed. */
  async close(): Promise<void> {
    await this.client.close();
    await this.#port.close();
  }
}

/** A port from opening to closing, and word of its loss. */
class OpenPort {
  readonly lost: Promise<ConnectionError>;
  #tell: (error: ConnectionError) => void = () => {};
  readonly #port: SerialPortLike;
  readonly #onDisconnect = (): void => this.lose();

  constructor(port: SerialPortLike) {
    this.#port = port;
    this.lost = new Promise((resolve) => {
      this.#tell = resolve;
    });
    port.addEventListener('disconnect', this.#onDisconnect);
  }

  lose(cause?: unknown): void {
    this.#tell(new ConnectionError('lost', 'the port was unplugged or its stream failed', cause));
  }

  async close(): Promise<void> {
    this.#port.removeEventListener('disconnect', this.#onDisconnect);
    // A port that is unplugged or half open may refuse; there is nothing left to close then.
    await this.#port.close().catch(() => {});
  }
}

/**
 * Opens a port and asks the timer behind it what it is. When that fails the port is closed again.
 * @throws ConnectionError `busy`, `unplugged`, `no-answer`, `bad-reply`, `lost`; TimerError `aborted`.
 */
export async function connect(port: SerialPortLike, options: ConnectOptions = {}): Promise<TimerConnection> {
  const { baudRate = 9600, clock = realClock, signal, onLine } = options;
  try {
    await port.open({ baudRate, dataBits: 8, stopBits: 1, parity: 'none', bufferSize: BUFFER_SIZE });
  } catch (error) {
    if (port.connected === false) throw new ConnectionError('unplugged', 'the port is not plugged in', error);
    throw new ConnectionError('busy', 'the port cannot be opened', error);
  }
  const open = new OpenPort(port);
  const client = new TimerClient(port, { baudRate, clock, onLine, onLost: (error) => open.lose(error) });
  try {
    const identity = await client.identify({ signal });
    return new TimerConnection(client, identity, open);
  } catch (error) {
    await client.close();
    await open.close();
    throw identifyFailure(error);
  }
}

function identifyFailure(error: unknown): unknown {
  if (!(error instanceof TimerError)) return error;
  switch (error.code) {
    case 'no-answer':
      return new ConnectionError('no-answer', 'nothing on this port answers as a timer does', error);
    case 'bad-reply':
    case 'unstable':
      return new ConnectionError('bad-reply', 'the answer cannot be right', error);
    case 'port-lost':
      return new ConnectionError('lost', 'the port was lost while the timer was asked what it is', error);
    default:
      return error;
  }
}
