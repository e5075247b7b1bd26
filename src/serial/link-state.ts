import type { TimerClient } from '../client/index.js';
import type { Identity } from '../protocol/index.js';
import type { ConnectionError } from './errors.js';
import type { PortKind } from './ports.js';
import type { Heard } from './rate-listener.js';
import type { OpenedSettings } from './settings.js';
import type { PortInfo, SerialPortLike } from './types.js';

/** An open port with a timer behind it that has said what it is. */
export interface TimerConnection {
  readonly client: TimerClient;
  readonly identity: Identity;
  /** As the port is open, with the rate at which the timer answered. */
  readonly settings: OpenedSettings;
  readonly info: PortInfo;
  readonly kind: PortKind;
  /** The name under which settings of this port are remembered, see `portKey`. */
  readonly portKey: string;
}

/** Where a link stands, see `LINK_TABLE` for what each status means and what follows it. */
export type LinkState =
  | {
      readonly status: 'off';
      /** Why it ended; null when nothing was wrong. */
      readonly error: ConnectionError | null;
    }
  | { readonly status: 'choosing' }
  | {
      readonly status: 'opening';
      readonly port: SerialPortLike;
      /** How often the port has refused to open. */
      readonly refusals: number;
      /** When it is given up, in milliseconds by the link's clock; null while the port has not refused. */
      readonly until: number | null;
    }
  | {
      readonly status: 'searching';
      readonly port: SerialPortLike;
      /** The rate that is being tried, bits a second. */
      readonly baudRate: number;
      /** Which of the rates to try it is, from 1 to `steps`. */
      readonly step: number;
      readonly steps: number;
    }
  | {
      readonly status: 'waiting';
      readonly port: SerialPortLike;
      /** The rate at which it is asked, bits a second. */
      readonly baudRate: number;
      /** How often it was asked in vain since it is waited for. */
      readonly asked: number;
      /** What else talks on the port, by all that came at any rate; null while nothing does. */
      readonly heard: Heard | null;
    }
  | { readonly status: 'on'; readonly port: SerialPortLike; readonly connection: TimerConnection }
  | {
      readonly status: 'away';
      /** The port that was lost. It may return as another object. */
      readonly port: SerialPortLike;
      readonly info: PortInfo;
      readonly error: ConnectionError;
      /** Whether it is known to be unplugged; else its stream has failed, and its plug may be in. */
      readonly unplugged: boolean;
    }
  | { readonly status: 'closing' };
