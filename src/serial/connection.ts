import { type LineEntry, TimerClient, TimerError } from '../client/index.js';
import { type Clock, realClock } from '../line/index.js';
import type { Identity } from '../protocol/index.js';
import { ConnectionError } from './errors.js';
import type { TimerConnection } from './link-state.js';
import { PortOpener } from './port-opener.js';
import { type PortKind, portKey, portKind } from './ports.js';
import { impossible } from './probe.js';
import { DEFAULT_SETTINGS, type OpenedSettings } from './settings.js';
import type { PortInfo, SerialPortLike } from './types.js';

export interface ConnectOptions {
  /** Bits a second. Default 9600, 8 data bits, no parity, 1 stop bit: see the protocol page on the speed of the line. */
  readonly baudRate?: number;
  /** Default: the real clock. */
  readonly clock?: Clock;
  readonly signal?: AbortSignal;
  /** Told of everything on the line. */
  readonly onLine?: (entry: LineEntry) => void;
}

/** An open port with a timer behind it that has said what it is, for whoever opens and closes it by hand. */
export class DirectConnection implements TimerConnection {
  readonly client: TimerClient;
  readonly identity: Identity;
  readonly settings: OpenedSettings;
  readonly info: PortInfo;
  readonly kind: PortKind;
  readonly portKey: string;
  /** Settles when the port is unplugged or its stream fails, with ConnectionError `lost`; never after {@link close}. */
  readonly lost: Promise<ConnectionError>;
  readonly #opener: PortOpener;
  readonly #watch: LossWatch;

  /** Use {@link connect}. */
  constructor(client: TimerClient, identity: Identity, opener: PortOpener, watch: LossWatch) {
    this.client = client;
    this.identity = identity;
    this.settings = opener.settings as OpenedSettings;
    this.info = opener.port.getInfo();
    this.kind = portKind(this.info);
    this.portKey = portKey(this.info);
    this.lost = watch.lost;
    this.#opener = opener;
    this.#watch = watch;
  }

  /** Lets the request under way end, releases the streams and closes the port. Never throws: a port that is gone is closed. */
  async close(): Promise<void> {
    await this.client.close();
    this.#watch.end();
    await this.#opener.close();
  }
}

/** Word of the loss of an open port. */
class LossWatch {
  readonly lost: Promise<ConnectionError>;
  readonly #port: SerialPortLike;
  #tell: (error: ConnectionError) => void = () => {};
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

  end(): void {
    this.#port.removeEventListener('disconnect', this.#onDisconnect);
  }
}

/**
 * Opens a port and asks the timer behind it what it is, once, at one rate: the simple way in. {@link TimerLink} finds the rate, waits for
 * timers that sleep and opens lost ports again. When it fails the port is closed again.
 * @throws ConnectionError `busy`, `unplugged`, `bad-settings`, `no-answer`, `bad-reply`, `lost`; TimerError `aborted`.
 */
export async function connect(port: SerialPortLike, options: ConnectOptions = {}): Promise<DirectConnection> {
  const { baudRate = 9600, clock = realClock, signal, onLine } = options;
  const opener = new PortOpener(port, clock);
  await opener.open({ ...DEFAULT_SETTINGS, baudRate });
  const watch = new LossWatch(port);
  const client = new TimerClient(port, { baudRate, clock, onLine, onLost: (error) => watch.lose(error) });
  try {
    const identity = await client.identify({ signal });
    return new DirectConnection(client, identity, opener, watch);
  } catch (error) {
    await client.close();
    watch.end();
    await opener.close();
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
    case 'crowded':
      return impossible(error);
    case 'port-lost':
      return new ConnectionError('lost', 'the port was lost while the timer was asked what it is', error);
    default:
      return error;
  }
}
