import type { Identity } from '../protocol/index.js';
import type { Exchange } from './exchange.js';
import type { Quirks } from './quirks.js';

/** What every job of the client works with. */
export interface ClientJob {
  readonly exchange: Exchange;
  readonly identity: Identity;
  readonly signal: AbortSignal | undefined;
  readonly quirks: Quirks;
}
