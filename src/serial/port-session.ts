import { TimerError, tell } from '../client/index.js';
import { sameKind } from '../program/index.js';
import { ConnectionError } from './errors.js';
import type { LinkContext } from './link-context.js';
import type { LinkState, TimerConnection } from './link-state.js';
import type { LinkEvent } from './link-table.js';
import { pause } from './pause.js';
import { PortOpener } from './port-opener.js';
import type { KnownPort } from './ports.js';
import { Probe, type ProbedTimer } from './probe.js';
import { clearest, RateListener } from './rate-listener.js';
import { ReturnWatch } from './return-watch.js';
import { quietRate, type Rates, ratesToTry } from './settings.js';

/** How often to try a port that refuses to open, and when to give up, in milliseconds. */
const OPEN_EVERY = 1000;
const OPEN_FOR = 15_000;
/** Milliseconds from one quiet question to the next. */
const ASK_EVERY = 1000;
/** For how many quiet questions in a row to stay at a rate at which a reply seems to come, byte by byte. */
const HOLD = 20;

/** Why a port session ended. The port is closed. */
export type PortSessionEnd =
  | { readonly why: 'stopped' }
  | { readonly why: 'failed'; readonly error: ConnectionError }
  | {
      readonly why: 'lost';
      readonly error: ConnectionError;
      /** Whether the port was known to be unplugged at the loss. */
      readonly unplugged: boolean;
      readonly watch: ReturnWatch;
      /** Milliseconds from the first opening to the loss. */
      readonly lasted: number;
    };

/**
 * One port session, from opening a plugged-in port until it is lost or left: `opening`, `searching`, `waiting`, `on`.
 */
export class PortSession {
  readonly #context: LinkContext;
  readonly #known: KnownPort;
  readonly #opener: PortOpener;
  readonly #over = new AbortController();
  #end: PortSessionEnd = { why: 'stopped' };
  #openedAt: number | null = null;
  /** Asks at the current rate of the port; null once a timer has been found, or while the port is closed. */
  #probe: Probe | null = null;
  /** What was heard at each rate. */
  readonly #listeners = new Map<number, RateListener>();
  /** The connection while it is on, and how to leave it. */
  #on: { readonly connection: TimerConnection; readonly leave: (to: 'search' | 'wait') => void } | null = null;

  constructor(context: LinkContext, known: KnownPort) {
    this.#context = context;
    this.#known = known;
    this.#opener = new PortOpener(known.port, context.clock);
  }

  /** @param event why the session begins. */
  async run(event: 'open' | 'returned'): Promise<PortSessionEnd> {
    const { port } = this.#known;
    const { stop } = this.#context;
    const onStop = (): void => this.#over.abort();
    const onDisconnect = (): void => this.#lose(undefined, true);
    stop.addEventListener('abort', onStop);
    port.addEventListener('disconnect', onDisconnect);
    try {
      if (stop.aborted) onStop();
      for (let next: 'open' | 'returned' | 'refused' = event; !this.#isOver; next = 'refused') {
        await this.#open(next);
        await this.#meet();
      }
    } catch (error) {
      if (!(error instanceof ConnectionError)) throw error;
      this.#finish({ why: 'failed', error });
    } finally {
      await this.#endProbe();
      await this.#opener.close();
      port.removeEventListener('disconnect', onDisconnect);
      stop.removeEventListener('abort', onStop);
    }
    return this.#end;
  }

  /** Leaves a connection that is on: nothing answers any more, or another timer does. */
  askAgain(why: 'silent' | 'another'): void {
    const on = this.#on;
    if (!on) return;
    this.#on = null;
    const [rate] = this.#rates;
    this.#tell(why, why === 'silent' ? this.#waiting(rate) : this.#searching(rate));
    on.leave(why === 'silent' ? 'wait' : 'search');
  }

  /** Asks the timer whether it is still there. */
  async recheck(): Promise<void> {
    const on = this.#on;
    if (!on) return;
    const { client, identity } = on.connection;
    let why: 'silent' | 'another' | null;
    try {
      const found = await client.identify({ signal: this.#over.signal });
      why = sameKind(found, identity) ? null : 'another';
    } catch (error) {
      if (!(error instanceof TimerError)) throw error;
      // Damage on the line, a lost port or a stop by the pilot say nothing about the timer.
      why = error.code === 'no-answer' || error.code === 'bad-reply' ? 'silent' : null;
    }
    if (why) this.askAgain(why);
  }

  get #isOver(): boolean {
    return this.#over.signal.aborted;
  }

  get #rates(): Rates {
    const { settings, knownRate } = this.#context;
    return ratesToTry(settings, this.#known.kind === 'bluetooth', knownRate);
  }

  /**
   * Opens the port. Tries again while the port is there and refuses. @throws ConnectionError `busy` after the last try,
   * or `bad-settings`.
   */
  async #open(event: 'open' | 'returned' | 'refused'): Promise<void> {
    const { clock, settings } = this.#context;
    const [baudRate] = this.#rates;
    let refusals = 0;
    let until: number | null = null;
    const refused = async (): Promise<void> => {
      until ??= clock.now() + OPEN_FOR;
      refusals++;
      this.#tell('refused', this.#opening(refusals));
      await pause(clock, OPEN_EVERY, this.#over.signal);
    };
    if (event === 'refused') await refused();
    else this.#tell(event, this.#opening(0));
    while (!this.#isOver) {
      try {
        await this.#opener.open({ ...settings, baudRate }, this.#over.signal);
        break;
      } catch (error) {
        if (!(error instanceof ConnectionError)) throw error;
        if (error.code === 'unplugged') return this.#lose(error);
        if (error.code !== 'busy' || (until !== null && clock.now() >= until)) throw error;
        await refused();
      }
    }
    if (!this.#opener.settings) return;
    this.#openedAt ??= clock.now();
    this.#context.wasOpen = true;
    this.#tell('opened', this.#searching(baudRate));
  }

  /** Finds a timer and stays with it, until the port refuses to open at another rate or the session ends. */
  async #meet(): Promise<void> {
    let next: 'search' | 'wait' = 'search';
    while (!this.#isOver) {
      const found = next === 'search' ? await this.#search() : await this.#wait();
      if (found === 'refused') return;
      if (found === 'silent') next = 'wait';
      else next = await this.#stayWith(found);
    }
  }

  /** Tries each rate once, the likeliest twice. */
  async #search(): Promise<ProbedTimer | 'silent' | 'refused'> {
    const rates = this.#rates;
    for (const [index, baudRate] of rates.entries()) {
      if (index > 0) this.#tell('asked', this.#searching(baudRate));
      // The adapter may not know a rate. Another program may have taken the port in the meantime, which shows below.
      if (!(await this.#setRate(baudRate))) continue;
      const found = (await this.#ask()) ?? (index === 0 ? await this.#ask() : null);
      if (found) return found;
    }
    if (!(await this.#setRate(rates[0]))) return 'refused';
    this.#tell('silent', this.#waiting(rates[0]));
    return 'silent';
  }

  /** Asks quietly until something answers. */
  async #wait(): Promise<ProbedTimer | 'refused'> {
    const { clock } = this.#context;
    const rates = this.#rates;
    let baudRate: number = rates[0];
    for (let asked = 0, held = 0; !this.#isOver; asked++) {
      const begin = clock.now();
      held = this.#listenerAt(baudRate).isReplyBegun && held < HOLD ? held + 1 : 0;
      if (held === 0) baudRate = quietRate(rates, asked);
      if (asked > 0) this.#tell('asked', this.#waiting(baudRate));
      const isOpen = await this.#setRate(baudRate);
      if (!isOpen && baudRate === rates[0]) break;
      const found = isOpen && (await this.#ask());
      if (found) return found;
      await pause(clock, begin + ASK_EVERY - clock.now(), this.#over.signal);
    }
    return 'refused';
  }

  /** Lets the pilot work with the timer until the link has to ask for its identity again. */
  async #stayWith({ client, identity, settings }: ProbedTimer): Promise<'search' | 'wait'> {
    const { port, info, kind, key } = this.#known;
    this.#context.knownRate = settings.baudRate;
    this.#listeners.clear();
    const quirks = tell(this.#context.assumed, identity, key);
    if (quirks) client.assume(quirks);
    const connection = { client, identity, settings, info, kind, portKey: key };
    const left = new Promise<'search' | 'wait'>((leave) => {
      this.#on = { connection, leave };
      this.#over.signal.addEventListener('abort', () => leave('wait'));
      if (this.#isOver) leave('wait');
    });
    this.#tell('answered', { status: 'on', port, connection });
    const next = await left;
    this.#on = null;
    this.#context.margin = client.margin;
    await client.close();
    return next;
  }

  /** Asks once at the current rate. A client that has found a timer belongs to the connection from then on. */
  async #ask(): Promise<ProbedTimer | null> {
    const { settings, port } = this.#opener;
    if (this.#isOver || !settings) return null;
    this.#probe ??= new Probe(port, settings, this.#context, this.#listenerAt(settings.baudRate), (error) =>
      this.#lose(error),
    );
    const found = await this.#probe.ask(this.#over.signal);
    if (found) this.#probe = null;
    return found;
  }

  async #endProbe(): Promise<void> {
    await this.#probe?.close();
    this.#probe = null;
  }

  #listenerAt(baudRate: number): RateListener {
    const listener = this.#listeners.get(baudRate) ?? new RateListener(baudRate);
    this.#listeners.set(baudRate, listener);
    return listener;
  }

  /** @returns whether the port is now open at this rate. */
  async #setRate(baudRate: number): Promise<boolean> {
    if (this.#isOver) return false;
    if (this.#opener.settings?.baudRate !== baudRate) await this.#endProbe();
    try {
      await this.#opener.open({ ...this.#context.settings, baudRate }, this.#over.signal);
      return true;
    } catch (error) {
      if (!(error instanceof ConnectionError)) throw error;
      return false;
    }
  }

  /** Notes that the port is gone, or that its stream has failed. */
  #lose(cause?: unknown, unplugged = this.#known.port.connected === false): void {
    if (this.#isOver) return;
    const { clock, serial, wasOpen } = this.#context;
    const { port, info } = this.#known;
    if (!wasOpen) {
      const error = new ConnectionError('unplugged', 'the port is not plugged in', cause);
      this.#finish({ why: 'failed', error });
      return;
    }
    const error = new ConnectionError('lost', 'the port was unplugged or its stream failed', cause);
    const lasted = clock.now() - (this.#openedAt ?? clock.now());
    this.#finish({ why: 'lost', error, unplugged, watch: new ReturnWatch(port, serial, clock), lasted });
    // Reported at once, before any request in progress fails.
    this.#context.tell('lost', { status: 'away', port, info, error, unplugged });
  }

  #finish(end: PortSessionEnd): void {
    if (this.#isOver) return;
    this.#end = end;
    this.#over.abort();
  }

  #tell(event: LinkEvent, state: LinkState): void {
    if (!this.#isOver) this.#context.tell(event, state);
  }

  #opening(refusals: number): LinkState {
    return { status: 'opening', port: this.#known.port, refusals };
  }

  #searching(baudRate: number): LinkState {
    return { status: 'searching', port: this.#known.port, baudRate };
  }

  #waiting(baudRate: number): LinkState {
    const heard = clearest([...this.#listeners.values()].map((listener) => listener.heard));
    return { status: 'waiting', port: this.#known.port, baudRate, heard };
  }
}
