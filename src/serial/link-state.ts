import type { TimerClient } from '../client/index.js';
import type { Identity } from '../protocol/index.js';
import type { ConnectionError } from './errors.js';
import type { PortKind } from './ports.js';
import type { Heard } from './rate-listener.js';
import type { OpenedSettings } from './settings.js';
import type { PortInfo, SerialPortLike } from './types.js';

/** An open port with a timer that has said what it is. */
export interface TimerConnection {
  /** Reads and writes the timer. It is closed when the connection ends. */
  readonly client: TimerClient;
  /** What the timer has said about itself. */
  readonly identity: Identity;
  /** The settings of the open port, with the rate at which the timer answered. */
  readonly settings: OpenedSettings;
  /** What the port says about itself. */
  readonly info: PortInfo;
  /** The kind of adapter. */
  readonly kind: PortKind;
  /** The name by which settings of this port are remembered, see `KnownPort`. */
  readonly portKey: string;
}

/** The state of a link. `LINK_TABLE` says what each status means and what follows it. */
export type LinkState =
  | {
      readonly status: 'off';
      /** Why it ended; null when nothing went wrong. */
      readonly error: ConnectionError | null;
    }
  | { readonly status: 'choosing' }
  | {
      readonly status: 'opening';
      readonly port: SerialPortLike;
      /** How often the port has refused to open. */
      readonly refusals: number;
    }
  | {
      readonly status: 'searching';
      readonly port: SerialPortLike;
      /** The rate that is being tried, in bits a second. */
      readonly baudRate: number;
    }
  | {
      readonly status: 'waiting';
      readonly port: SerialPortLike;
      /** The rate at which the link asks, in bits a second. */
      readonly baudRate: number;
      /** What else talks on the port, at any rate; null while nothing does. */
      readonly heard: Heard | null;
    }
  | { readonly status: 'on'; readonly port: SerialPortLike; readonly connection: TimerConnection }
  | {
      readonly status: 'away';
      /** The port that was lost. It may come back as another object. */
      readonly port: SerialPortLike;
      readonly info: PortInfo;
      readonly error: ConnectionError;
      /** Whether the port is known to be unplugged. If not, its stream has failed, and it may still be plugged in. */
      readonly unplugged: boolean;
    }
  | { readonly status: 'closing' };
