import type { ConnectionError } from './errors.js';
import type { LinkContext } from './link-context.js';
import { pause } from './pause.js';
import { PortSession, type PortSessionEnd } from './port-session.js';
import { type KnownPort, known } from './ports.js';
import type { ReturnWatch } from './return-watch.js';

/**
 * How long to wait before a port is opened again that failed while plugged in: after the first failure in a row, the
 * second, and so on. Milliseconds.
 */
const REOPEN_AFTER = [200, 1000, 2000, 4000, 8000];
/** A port that stayed open for this many milliseconds does not count as failing in a row. */
const STEADY = 10_000;

/** One call to connect: port sessions, and between them the wait for the port to return. */
export class Reconnector {
  readonly #context: LinkContext;
  readonly #stop: AbortController;
  known: KnownPort;
  #portSession: PortSession | null = null;
  #watch: ReturnWatch | null = null;
  #failures = 0;
  #ended: Promise<void> = Promise.resolve();

  constructor(known: KnownPort, context: Omit<LinkContext, 'stop' | 'wasOpen'>) {
    this.known = known;
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

  start(): void {
    this.#ended = this.#run();
  }

  /** Ends it; from then on no state is reported. Settles when the port is closed. */
  async stop(): Promise<void> {
    this.#stop.abort();
    await this.#ended;
  }

  /** See {@link PortSession.askAgain}. */
  askAgain(): void {
    this.#portSession?.askAgain('silent');
  }

  /** Checks whether the timer is still there, or whether the lost port is back. */
  async recheck(): Promise<void> {
    this.#watch?.look();
    await this.#portSession?.recheck();
  }

  async #run(): Promise<void> {
    for (let event: 'open' | 'returned' = 'open'; !this.#stop.signal.aborted; event = 'returned') {
      this.#portSession = new PortSession(this.#context, this.known);
      const end = await this.#portSession.run(event);
      this.#portSession = null;
      const error = end.why === 'lost' ? await this.#await(end) : end.why === 'failed' ? end.error : null;
      if (error) return this.#context.tell('failed', { status: 'off', error });
    }
  }

  /**
   * Waits until the port is back, or the link ends.
   * @returns why the wait is over.
   */
  async #await({ watch, lasted, error, unplugged }: PortSessionEnd & { why: 'lost' }): Promise<ConnectionError | null> {
    this.#watch = watch;
    try {
      if (lasted >= STEADY) this.#failures = 0;
      // The plug may be pulled at any moment after the loss. Then it is no failure in a row, and no delay is needed.
      if ((await watch.isThere()) && !watch.gone.aborted) {
        // A port that fails as soon as it is open, reopened at once and for ever, would keep the page busy.
        const delay = REOPEN_AFTER[this.#failures++];
        if (delay === undefined) return error;
        await pause(this.#context.clock, delay, this.#stop.signal, watch.gone);
      }
      if (watch.gone.aborted) this.#failures = 0;
      // A stream may fail before the browser says that the plug was pulled.
      if (!unplugged && !(await watch.isThere())) {
        const { port, info } = this.known;
        this.#context.tell('unplugged', { status: 'away', port, info, error, unplugged: true });
      }
      const port = await watch.returned(this.#stop.signal);
      if (port) this.known = known(port);
      return null;
    } finally {
      this.#watch = null;
      watch.end();
    }
  }
}
