import { TimerClient, TimerError } from '../client/index.js';
import type { CodecError, Identity } from '../protocol/index.js';
import { ConnectionError } from './errors.js';
import type { LinkContext } from './link-context.js';
import type { RateListener } from './rate-listener.js';
import type { OpenedSettings } from './settings.js';
import type { SerialPortLike } from './types.js';

/** How often in a row an impossible answer must come to be believed: a damaged one sometimes passes the checksum. */
const BAD_REPLIES = 3;

/** A timer that has said what it is, and the client that asked it. */
export interface ProbedTimer {
  readonly client: TimerClient;
  readonly identity: Identity;
  readonly settings: OpenedSettings;
}

/**
 * Asks on an open port, at one rate, whether there is a timer (GETSWVER), any number of times. A late reply to an
 * earlier question serves as well, so it finds a slow timer, too.
 */
export class Probe {
  readonly #client: TimerClient;
  readonly #settings: OpenedSettings;
  readonly #listener: RateListener;

  constructor(
    port: SerialPortLike,
    settings: OpenedSettings,
    { clock, onLine, margin }: LinkContext,
    listener: RateListener,
    onLost: (error: TimerError) => void,
  ) {
    const { baudRate } = settings;
    this.#settings = settings;
    this.#listener = listener;
    this.#client = new TimerClient(port, {
      baudRate,
      clock,
      margin,
      onLine: (entry) => {
        listener.note(entry);
        onLine?.(entry);
      },
      onLost,
    });
  }

  /**
   * Asks once.
   * @returns null when nothing answered, the signal asked to stop, or the port was lost.
   * @throws ConnectionError `bad-reply`.
   */
  async ask(signal: AbortSignal): Promise<ProbedTimer | null> {
    const client = this.#client;
    this.#listener.next();
    for (let bad = 1; ; bad++) {
      try {
        const identity = await client.identify({ signal, tries: 1, anyReply: true });
        return { client, identity, settings: this.#settings };
      } catch (error) {
        if (!(error instanceof TimerError)) throw error;
        if (error.code !== 'bad-reply' || signal.aborted) return null;
        if (bad === BAD_REPLIES) throw impossible(error);
      }
    }
  }

  /** Releases the port. */
  close(): Promise<void> {
    return this.#client.close();
  }
}

/** Something answered with an identity that no timer can have. The error carries its bytes. */
function impossible(error: TimerError): ConnectionError {
  const { details } = (error.cause ?? {}) as Partial<CodecError>;
  return new ConnectionError('bad-reply', 'the answer cannot be right', error, details?.bytes);
}
