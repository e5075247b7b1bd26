import { TimerError } from '../../client/index.js';
import type { TimerProgram } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { JobContext } from '../timer/job-runner.js';
import type { RoundTrip } from '../work/interrupted-jobs.js';
import type { Session } from '../work/session.js';

export type RoundTripParts = Pick<Session, 'recovery' | 'nextFlight' | 'editor' | 'onScreen' | 'reader' | 'simulated'>;

/** A memory round trip: notes on the way which memory to restore, and at the end what is known. */
export class NotedRoundTrip {
  readonly #parts: RoundTripParts;
  readonly #trip: RoundTrip;
  /** The memory to restore, while another one is selected. */
  #original: number | null = null;

  /** @param trip what is done on it. */
  constructor(parts: RoundTripParts, trip: RoundTrip) {
    this.#parts = parts;
    this.#trip = trip;
  }

  /** Reads some or all memories, then restores the current one. */
  async read(
    { client, identity }: TimerConnection,
    options: JobContext & { readonly memories?: readonly number[] },
  ): Promise<readonly TimerProgram[]> {
    const { programs, original } = await client
      .readMemories({ ...options, onOriginal: (original) => this.leave(identity, original) })
      .catch(async (error: unknown) => {
        await this.wasRestored(identity, this.#original, error);
        throw error;
      });
    options.stillOn();
    for (const program of programs) this.#parts.reader.took(program);
    await this.wasRestored(identity, original, null);
    return programs;
  }

  /** Another memory is about to be selected: notes the one to restore. */
  async leave(identity: Identity, original: number): Promise<void> {
    const { recovery, simulated, nextFlight } = this.#parts;
    this.#original = original;
    await recovery.leave(this.#trip, identity, original, simulated.value);
    nextFlight.leave(null);
  }

  /**
   * Notes that the original is current again, as the timer says;
   * not if it could not be selected, or another timer answers.
   */
  async wasRestored(identity: Identity, original: number | null, stopped: unknown): Promise<void> {
    const { recovery, simulated, nextFlight, editor, onScreen } = this.#parts;
    const wasLeft = this.#original !== null;
    this.#original = null;
    const isOpen = stopped instanceof TimerError && ['memory-left', 'other-timer'].includes(stopped.code);
    if (original === null || isOpen) return;
    nextFlight.found(original, onScreen.apart.value || original === editor.baseline.value?.memory);
    if (wasLeft && recovery.offer.value?.kind !== 'memories') await recovery.wasRestored(identity, simulated.value);
  }
}
