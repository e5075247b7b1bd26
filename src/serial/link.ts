import { type AssumedQuirks, asyncDisposable, type LineEntry, tell } from '../client/index.js';
import { type Clock, realClock } from '../line/index.js';
import type { Identity } from '../protocol/index.js';
import { refused } from './choose.js';
import { ConnectionError } from './errors.js';
import type { LinkState } from './link-state.js';
import { type LinkEvent, nextStatus } from './link-table.js';
import { type KnownPort, known } from './ports.js';
import { Reconnector } from './reconnector.js';
import { DEFAULT_SETTINGS, type SerialSettings } from './settings.js';
import type { SerialLike, SerialPortLike } from './types.js';

/** What an application remembers of a port, by its key, see `KnownPort`. */
export interface RememberedPort {
  /** How the pilot wants the port to be opened. Default: `DEFAULT_SETTINGS`. */
  readonly settings?: SerialSettings | undefined;
  /** The rate at which a timer has answered there, in bits a second. It is tried first. */
  readonly knownRate?: number | undefined;
}

/** What a link needs from its surroundings, and whom it tells. Nothing is required. */
export interface TimerLinkOptions {
  /** `navigator.serial`. Without it there is no chooser, and a lost port is found again only as the same object. */
  readonly serial?: SerialLike | undefined;
  /** See `Surroundings`. */
  readonly policyAllows?: boolean | undefined;
  /** Default: the real clock. */
  readonly clock?: Clock | undefined;
  /** Called with everything on the line, also with the questions at rates where nothing answers. */
  readonly onLine?: ((entry: LineEntry) => void) | undefined;
  /** Called with every new state, one after the other, in an order that `LINK_TABLE` allows. */
  readonly onState?: ((state: LinkState) => void) | undefined;
  /** Gives what is remembered of a port, for calls of `choose()` and `connect()` that do not say it. */
  readonly remembered?: ((portKey: string) => RememberedPort | undefined) | undefined;
  /** Gives what is remembered of such a timer on such a port, once the timer has said what it is. */
  readonly assumed?: ((identity: Identity, portKey: string) => AssumedQuirks | undefined) | undefined;
}

/**
 * A link to a timer for use in the field. It finds the rate and the timer, waits while the timer sleeps, reopens a port
 * that was lost, and stops at any time. It sends only the question for the identity (GETSWVER); the user of the
 * connection sends everything else. You may call every method at any time. None rejects unless its description says so.
 * `await using link = new TimerLink(...)` stops it at the end of the block.
 * @example
 * ```ts
 * import { MockSerial } from 'sidus-timer/mock-serial';
 * import { TimerLink } from 'sidus-timer/serial';
 *
 * const serial = new MockSerial(); // in a browser: navigator.serial
 * const states: string[] = [];
 * const link = new TimerLink({ serial, onState: ({ status }) => states.push(status) });
 * void link.connect(serial.plug({}, { granted: true }));
 * await link.stop();
 * console.log(states.at(-1)); // off
 * ```
 */
export class TimerLink {
  static {
    asyncDisposable(TimerLink.prototype, (link) => link.stop());
  }

  /** The same as {@link stop}, for `await using`. */
  declare readonly [Symbol.asyncDispose]: () => Promise<void>;
  readonly #options: TimerLinkOptions;
  readonly #clock: Clock;
  #state: LinkState = { status: 'off', error: null };
  #reconnector: Reconnector | null = null;
  /** Counts the calls of the pilot and the choosers shown. Only the newest of each counts. */
  #newest = 0;
  #chooser = 0;
  /** Callers that wait for the link to settle. */
  #waiting: (() => void)[] = [];

  /** @param options where ports come from, what is remembered of them, and whom to tell. */
  constructor(options: TimerLinkOptions = {}) {
    this.#options = options;
    this.#clock = options.clock ?? realClock;
  }

  /** Where the link is now. */
  get state(): LinkState {
    return this.#state;
  }

  /**
   * The plugged-in ports that the pilot has allowed before. Needs no click.
   * @throws ConnectionError `policy` or `not-allowed`.
   */
  async ports(): Promise<KnownPort[]> {
    const { serial, policyAllows } = this.#options;
    const ports = await serial?.getPorts().catch((error) => Promise.reject(refused(error, policyAllows)));
    // Some browsers list what is not plugged in, too.
    return (ports ?? []).filter(({ connected }) => connected !== false).map(known);
  }

  /**
   * Lets the pilot choose a port and connects to it. Call it from a click. An open connection stays until a port is
   * chosen. If none is chosen, it goes on; without one, the state says why no port was chosen.
   * @param settings default: those remembered for the chosen port, else `DEFAULT_SETTINGS`.
   * @returns once the chooser is closed without a port, or as {@link connect}.
   */
  async choose(settings?: SerialSettings): Promise<void> {
    const { serial, policyAllows } = this.#options;
    const chooser = ++this.#chooser;
    let port: SerialPortLike;
    try {
      if (!serial) throw new ConnectionError('unsupported', 'this browser has no Web Serial');
      if (this.#state.status === 'off') this.#enter('choose', { status: 'choosing' });
      // Without filters: a list of USB vendors would hide Bluetooth ports and unknown adapters.
      port = await serial.requestPort();
    } catch (failure) {
      const error = failure instanceof ConnectionError ? failure : refused(failure, policyAllows);
      const { status } = this.#state;
      const isShown = status === 'choosing' || status === 'off';
      if (chooser === this.#chooser && isShown) this.#enter('failed', { status: 'off', error });
      return;
    }
    if (chooser === this.#chooser) await this.connect(port, settings);
  }

  /**
   * Connects to a port. Ends any other connection, or attempt, first.
   * @param settings default: those remembered for this port, else `DEFAULT_SETTINGS`.
   * @param options `signal`: gives the attempt up, as {@link stop} does. It no longer counts once the link has settled,
   * or once another call has taken over.
   * @returns once the link has settled: it is `on`, `waiting`, `away` or `off`.
   */
  async connect(
    port: SerialPortLike,
    settings?: SerialSettings,
    { signal }: { readonly signal?: AbortSignal | undefined } = {},
  ): Promise<void> {
    if (signal?.aborted) return;
    const mine = this.#supersede();
    const stop = (): void => {
      if (mine === this.#newest) void this.stop();
    };
    signal?.addEventListener('abort', stop);
    try {
      await this.#connect(mine, port, settings);
    } finally {
      signal?.removeEventListener('abort', stop);
    }
  }

  async #connect(mine: number, port: SerialPortLike, settings: SerialSettings | undefined): Promise<void> {
    if (this.#reconnector) await this.#end();
    if (mine !== this.#newest) return;
    const { serial, onLine, assumed, remembered } = this.#options;
    const at = known(port);
    const memory = tell(remembered, at.key);
    const reconnector = new Reconnector(at, {
      clock: this.#clock,
      serial,
      settings: settings ?? memory?.settings ?? DEFAULT_SETTINGS,
      knownRate: memory?.knownRate,
      margin: MARGIN,
      onLine,
      assumed,
      tell: (event, state) => this.#enter(event, state),
    });
    const settled = new Promise<void>((resolve) => this.#waiting.push(resolve));
    this.#reconnector = reconnector;
    reconnector.start();
    await settled;
  }

  /** Ends any connection or attempt. Settles once the link is off and the port closed, within the time of one reply. */
  async stop(): Promise<void> {
    const mine = this.#supersede();
    if (this.#state.status === 'choosing') this.#enter('stop', { status: 'off', error: null });
    await this.#end();
    if (mine === this.#newest && this.#state.status === 'closing')
      this.#enter('closed', { status: 'off', error: null });
  }

  /**
   * Call it when a connected timer no longer answers. The link then asks quietly on the same port until the timer does.
   * Does nothing unless the link is `on`.
   */
  wait(): void {
    this.#reconnector?.askAgain();
  }

  /**
   * Checks whether everything is still as the link believes, as after the sleep of the computer. A timer that is `on`
   * is asked for its identity once no other request waits. The same kind as before: nothing happens. Another: it is
   * identified again. No answer: the link waits for it. While the port is `away`, the link looks for it at once.
   */
  async recheck(): Promise<void> {
    await this.#reconnector?.recheck();
  }

  /** Gives the permission for a port back to the browser, where the browser supports that. Ends a link to it first. */
  async forget(port: SerialPortLike): Promise<void> {
    if (this.#reconnector?.known.port === port) await this.stop();
    await port.forget?.();
  }

  #supersede(): number {
    this.#chooser++;
    return ++this.#newest;
  }

  /** Ends the reconnector, if there is one. Wait for this before starting another: it may be to the same port. */
  async #end(): Promise<void> {
    const reconnector = this.#reconnector;
    if (!reconnector) return;
    if (this.#state.status !== 'closing') this.#enter('stop', { status: 'closing' });
    await reconnector.stop();
    if (this.#reconnector === reconnector) this.#reconnector = null;
  }

  #enter(event: LinkEvent, state: LinkState): void {
    const next = nextStatus(this.#state.status, event);
    if (state.status !== next) throw new Error(`${event} leads to ${next}, not to ${state.status}`);
    this.#state = state;
    if (state.status === 'off') this.#reconnector = null;
    tell(this.#options.onState, state);
    if (!SETTLED.includes(this.#state.status)) return;
    for (const resolve of this.#waiting.splice(0)) resolve();
  }
}

/** How long a timer may take to answer at first, in milliseconds beyond the time of the bytes. */
const MARGIN = 600;
const SETTLED: readonly LinkState['status'][] = ['on', 'waiting', 'away', 'off'];
