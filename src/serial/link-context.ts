import type { AssumedQuirks, LineEntry } from '../client/index.js';
import type { Clock } from '../line/index.js';
import type { Identity } from '../protocol/index.js';
import type { LinkState } from './link-state.js';
import type { LinkEvent } from './link-table.js';
import type { SerialSettings } from './settings.js';
import type { SerialLike } from './types.js';

/** What all port sessions of one wish to connect share. */
export interface LinkContext {
  readonly clock: Clock;
  readonly serial: SerialLike | undefined;
  readonly settings: SerialSettings;
  readonly onLine: ((entry: LineEntry) => void) | undefined;
  readonly assumed: ((identity: Identity, portKey: string) => AssumedQuirks | undefined) | undefined;
  /** Asks to stop: nothing is told any more from then on. */
  readonly stop: AbortSignal;
  readonly tell: (event: LinkEvent, state: LinkState) => void;
  /** Milliseconds that the timer may take to answer, as it was last learned; see `TimerClient`. */
  margin: number;
  /** The rate at which a timer answered on this port, if one has. */
  knownRate: number | undefined;
  /** Whether the port could be opened since the pilot chose it: then a port that is gone is waited for. */
  wasOpen: boolean;
}
