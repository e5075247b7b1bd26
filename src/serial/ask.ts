import { TimerClient, TimerError } from '../client/index.js';
import type { Identity } from '../protocol/index.js';
import { ConnectionError } from './errors.js';
import type { PortOpener } from './port-opener.js';
import type { OpenedSettings } from './settings.js';
import type { Trip } from './trip.js';

/** How often an impossible answer must come in a row to be believed: a damaged one passes the checksum now and then. */
const BAD_REPLIES = 3;

/** A timer that has said what it is, and the client that asked it. */
export interface Found {
  readonly client: TimerClient;
  readonly identity: Identity;
  readonly settings: OpenedSettings;
}

/**
 * Asks once (GETSWVER) on an open port whether there is a timer. Each question has a client of its own, so that none is behind the
 * fences that an unanswered one would raise; a late reply to the one before says the same.
 * @returns null when nothing answered, the signal asked to stop, or the port was lost.
 * @throws ConnectionError `bad-reply`.
 */
export async function ask(
  { port, settings }: PortOpener,
  { clock, onLine }: Trip,
  onLost: (error: TimerError) => void,
  signal: AbortSignal,
): Promise<Found | null> {
  if (!settings) return null;
  for (let bad = 1; ; bad++) {
    const client = new TimerClient(port, { baudRate: settings.baudRate, clock, onLine, onLost });
    try {
      return { client, settings, identity: await client.identify({ signal, tries: 1 }) };
    } catch (error) {
      await client.close();
      if (!(error instanceof TimerError)) throw error;
      if (error.code !== 'bad-reply' || signal.aborted) return null;
      if (bad === BAD_REPLIES) throw new ConnectionError('bad-reply', 'the answer cannot be right', error);
    }
  }
}
