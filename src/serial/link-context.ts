import type { AssumedQuirks, LineEntry } from '../client/index.js';
import type { Clock } from '../line/index.js';
import type { Identity } from '../protocol/index.js';
import type { LinkState } from './link-state.js';
import type { LinkEvent } from './link-table.js';
import type { SerialSettings } from './settings.js';
import type { SerialLike } from './types.js';

/** What all port sessions of one call to connect share. */
export interface LinkContext {
  readonly clock: Clock;
  readonly serial: SerialLike | undefined;
  readonly settings: SerialSettings;
  readonly onLine: ((entry: LineEntry) => void) | undefined;
  readonly assumed: ((identity: Identity, portKey: string) => AssumedQuirks | undefined) | undefined;
  /** Asks to stop: from then on no state is reported. */
  readonly stop: AbortSignal;
  readonly tell: (event: LinkEvent, state: LinkState) => void;
  /** How long the timer may take to answer, in milliseconds, as last learned; see `TimerClient`. */
  margin: number;
  /** The rate at which a timer has answered on this port, if any. */
  knownRate: number | undefined;
  /** Whether the port has opened since the pilot chose it. Only then is a port that is gone waited for. */
  wasOpen: boolean;
}
