import type { ConnectionError } from './errors.js';
import { pause } from './pause.js';
import { type KnownPort, known } from './ports.js';
import type { ReturnWatch } from './return-watch.js';
import type { Trip } from './trip.js';
import { Visit, type VisitEnd } from './visit.js';

/** Milliseconds after which a port that fails with its plug in is opened again, the first time in a row, the second ... */
const REOPEN_AFTER = [200, 1000, 2000, 4000, 8000];
/** Milliseconds after which a port that stayed open so long does not count as failing in a row. */
const STEADY = 10_000;

/** The way of one wish to connect: visits to a port, and between them waiting for it to return. */
export class Journey {
  readonly #trip: Trip;
  readonly #stop: AbortController;
  #known: KnownPort;
  #visit: Visit | null = null;
  #watch: ReturnWatch | null = null;
  #failures = 0;
  #ended: Promise<void> = Promise.resolve();

  constructor(known: KnownPort, trip: Omit<Trip, 'stop' | 'wasOpen'>) {
    this.#known = known;
    this.#stop = new AbortController();
    this.#trip = {
      ...trip,
      stop: this.#stop.signal,
      wasOpen: false,
      tell: (event, state) => {
        if (!this.#stop.signal.aborted) trip.tell(event, state);
      },
    };
  }

  get known(): KnownPort {
    return this.#known;
  }

  start(): void {
    this.#ended = this.#run();
  }

  /** Ends it, and says nothing more. Settles when the port is closed. */
  async stop(): Promise<void> {
    this.#stop.abort();
    await this.#ended;
  }

  /** See {@link Visit.askAgain}. */
  askAgain(): void {
    this.#visit?.askAgain('silent');
  }

  /** Looks whether what was there still is, or what was lost is there again. */
  async recheck(): Promise<void> {
    this.#watch?.look();
    await this.#visit?.recheck();
  }

  async #run(): Promise<void> {
    for (let event: 'open' | 'returned' = 'open'; !this.#stop.signal.aborted; event = 'returned') {
      this.#visit = new Visit(this.#trip, this.#known);
      const end = await this.#visit.run(event);
      this.#visit = null;
      const error = end.why === 'lost' ? await this.#await(end) : end.why === 'failed' ? end.error : null;
      if (error) return this.#trip.tell('failed', { status: 'off', error });
    }
  }

  /**
   * Waits until the port is there again, or all is over.
   * @returns why it is no longer waited for.
   */
  async #await({ watch, lasted, error, unplugged }: VisitEnd & { why: 'lost' }): Promise<ConnectionError | null> {
    this.#watch = watch;
    try {
      if (lasted >= STEADY) this.#failures = 0;
      // The plug may be pulled at any moment from the loss on: then nothing failed in a row, and there is nothing to wait for.
      if ((await watch.isThere()) && !watch.gone.aborted) {
        // Opened at once and for ever, a port that fails as soon as it is open would keep the page busy.
        const delay = REOPEN_AFTER[this.#failures++];
        if (delay === undefined) return error;
        await pause(this.#trip.clock, delay, this.#stop.signal, watch.gone);
      }
      if (watch.gone.aborted) this.#failures = 0;
      // A stream may fail before the browser tells that the plug was pulled.
      if (!unplugged && !(await watch.isThere())) {
        const { port, info } = this.#known;
        this.#trip.tell('unplugged', { status: 'away', port, info, error, unplugged: true });
      }
      const port = await watch.returned(this.#stop.signal);
      if (port) this.#known = known(port);
      return null;
    } finally {
      this.#watch = null;
      watch.end();
    }
  }
}
