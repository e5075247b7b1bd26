import type { ConnectionError } from './errors.js';
import type { LinkContext } from './link-context.js';
import { pause } from './pause.js';
import { PortSession, type PortSessionEnd } from './port-session.js';
import { type KnownPort, known } from './ports.js';
import type { ReturnWatch } from './return-watch.js';

/**
 * Milliseconds after which a port that fails with its plug in is opened again, the first time in a row, the second ...
 */
const REOPEN_AFTER = [200, 1000, 2000, 4000, 8000];
/** Milliseconds after which a port that stayed open so long does not count as failing in a row. */
const STEADY = 10_000;

/** One wish to connect: port sessions, and between them waiting for the port to return. */
export class Reconnector {
  readonly #context: LinkContext;
  readonly #stop: AbortController;
  #known: KnownPort;
  #portSession: PortSession | null = null;
  #watch: ReturnWatch | null = null;
  #failures = 0;
  #ended: Promise<void> = Promise.resolve();

  constructor(known: KnownPort, context: Omit<LinkContext, 'stop' | 'wasOpen'>) {
    this.#known = known;
    this.#stop = new AbortController();
    this.#context = {
      ...context,
      stop: this.#stop.signal,
      wasOpen: false,
      tell: (event, state) => {
        if (!this.#stop.signal.aborted) context.tell(event, state);
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

  /** See {@link PortSession.askAgain}. */
  askAgain(): void {
    this.#portSession?.askAgain('silent');
  }

  /** Looks whether what was there still is, or what was lost is there again. */
  async recheck(): Promise<void> {
    this.#watch?.look();
    await this.#portSession?.recheck();
  }

  async #run(): Promise<void> {
    for (let event: 'open' | 'returned' = 'open'; !this.#stop.signal.aborted; event = 'returned') {
      this.#portSession = new PortSession(this.#context, this.#known);
      const end = await this.#portSession.run(event);
      this.#portSession = null;
      const error = end.why === 'lost' ? await this.#await(end) : end.why === 'failed' ? end.error : null;
      if (error) return this.#context.tell('failed', { status: 'off', error });
    }
  }

  /**
   * Waits until the port is there again, or all is over.
   * @returns why it is no longer waited for.
   */
  async #await({ watch, lasted, error, unplugged }: PortSessionEnd & { why: 'lost' }): Promise<ConnectionError | null> {
    this.#watch = watch;
    try {
      if (lasted >= STEADY) this.#failures = 0;
      // The plug may be pulled at any moment from the loss on: then nothing failed in a row, and there is nothing to
      // wait for.
      if ((await watch.isThere()) && !watch.gone.aborted) {
        // Opened at once and for ever, a port that fails as soon as it is open would keep the page busy.
        const delay = REOPEN_AFTER[this.#failures++];
        if (delay === undefined) return error;
        await pause(this.#context.clock, delay, this.#stop.signal, watch.gone);
      }
      if (watch.gone.aborted) this.#failures = 0;
      // A stream may fail before the browser tells that the plug was pulled.
      if (!unplugged && !(await watch.isThere())) {
        const { port, info } = this.#known;
        this.#context.tell('unplugged', { status: 'away', port, info, error, unplugged: true });
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
