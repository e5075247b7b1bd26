import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { AssumedQuirks, LineEntry } from '../../client/index.js';
import {
  availability,
  DEFAULT_SETTINGS,
  type KnownPort,
  type LinkState,
  type PortInfo,
  type RememberedPort,
  type SerialPortLike,
  type SerialSettings,
  type Surroundings,
  type TimerConnection,
  TimerLink,
} from '../../serial/index.js';
import { attempt } from '../browser/services.js';
import type { Keeper, PortRecord } from '../storage/index.js';
import { kindKey } from './record-keys.js';
import { secondsWaited } from './wait-clock.js';

/**
 * How long a browser may take to list the plugged-in ports, in milliseconds: after a click, the right to ask for a port
 * does not last long.
 */
const PORTS_LIMIT = 1000;

export interface LinkOptions {
  readonly surroundings: Surroundings;
  readonly ports: Keeper<PortRecord>;
  readonly onLine: (entry: LineEntry) => void;
}

/** The connection to a timer: its state, the known ports, and what is remembered of each. */
export class Link {
  readonly #state = signal<LinkState>({ status: 'off', error: null }, { name: 'link' });
  readonly #ports = signal<readonly KnownPort[]>([], { name: 'ports' });
  readonly #settings = signal<SerialSettings | null>(null, { name: 'settings' });
  /** Whether a connection was asked for and is being looked for. */
  readonly #beginning = signal(false, { name: 'beginning' });
  readonly state: ReadonlySignal<LinkState> = this.#state;
  readonly connection: ReadonlySignal<TimerConnection | null> = computed(() =>
    this.state.value.status === 'on' ? this.state.value.connection : null,
  );
  /** Whether something is in progress that needs no act of the pilot. */
  readonly busy: ReadonlySignal<boolean> = computed(
    () => this.#beginning.value || ['choosing', 'opening', 'searching'].includes(this.#state.value.status),
  );
  /**
   * Whether the link waits for a timer that does not answer, or for its adapter, until it is there or the pilot stops.
   */
  readonly waiting: ReadonlySignal<boolean> = computed(() => ['waiting', 'away'].includes(this.state.value.status));
  /** Whole seconds that a port takes to open, or a timer to answer at all; 0 while neither is waited for. */
  readonly waited: ReadonlySignal<number> = secondsWaited(this.#state);
  /** The plugged-in ports that the pilot has allowed before. */
  readonly ports: ReadonlySignal<readonly KnownPort[]> = this.#ports;
  /** The serial settings that the pilot has made; null: each port as it was last used. */
  readonly settings: ReadonlySignal<SerialSettings | null> = this.#settings;
  /** Whether the connected timer is simulated or a recording. */
  readonly simulated: ReadonlySignal<boolean> = computed(() => {
    const state = this.state.value;
    return 'port' in state && this.#simulated.has(state.port);
  });
  /** Why no connection is possible here at all; null when one is. */
  readonly unavailable: 'insecure' | 'policy' | 'unsupported' | null;
  readonly #options: LinkOptions;
  readonly #link: TimerLink;
  readonly #records = signal<ReadonlyMap<string, PortRecord>>(new Map(), { name: 'portRecords' });
  readonly #simulated = new WeakSet<SerialPortLike>();
  /** The reading of the remembered ports. */
  #learning: Promise<readonly PortRecord[]> = Promise.resolve([]);
  /** What is assumed about the connected timer, as last stored. */
  #quirksKept: AssumedQuirks | undefined;
  #onState: (state: LinkState, before: LinkState) => void = () => {};

  constructor(options: LinkOptions) {
    this.#options = options;
    const { serial } = options.surroundings;
    this.unavailable = availability(options.surroundings);
    this.#link = new TimerLink({
      serial,
      policyAllows: options.surroundings.policyAllows,
      onLine: options.onLine,
      onState: (state) => this.#follow(state),
      remembered: (key) => this.#remembered(key),
      assumed: (identity, key) => this.#records.peek().get(key)?.quirks[kindKey(identity, false)],
    });
  }

  /** Calls back with every new state, after {@link Link.state} has it. */
  onState(callback: (state: LinkState, before: LinkState) => void): void {
    this.#onState = callback;
  }

  /** Reads the remembered ports, and which ports are plugged in. */
  async start(): Promise<void> {
    await Promise.all([this.refresh(), this.#learnRecords()]);
    await this.refresh();
  }

  /** What this page has found out in the meantime is newer. */
  async #learnRecords(): Promise<void> {
    this.#learning = this.#options.ports.all().catch(() => []);
    for (const record of await this.#learning) {
      if (!this.#records.peek().has(record.key)) this.#put(record);
    }
  }

  /** Looks again which ports are plugged in. The ports used last come first. */
  async refresh(): Promise<void> {
    if (!this.#options.surroundings.serial) return;
    const ports = await attempt(() => this.#link.ports(), PORTS_LIMIT).catch(() => []);
    const usedAt = ({ key }: KnownPort): number => this.#records.peek().get(key)?.usedAt ?? 0;
    this.#ports.value = [...ports].sort((a, b) => usedAt(b) - usedAt(a));
  }

  /** What is remembered of a port: its last settings, and the rate at which a timer has answered. */
  recordOf(key: string): PortRecord | undefined {
    return this.#records.peek().get(key);
  }

  /** Sets how the next port is opened; null: as it was last opened. */
  setSettings(settings: SerialSettings | null): void {
    this.#settings.value = settings;
  }

  /**
   * Connects to a timer, and is busy from the first moment.
   * @param find finds its port, which may take time; null lets the pilot choose one.
   */
  async begin(find: () => Promise<SerialPortLike | null>): Promise<void> {
    this.#beginning.value = true;
    let going: Promise<void>;
    try {
      const port = await find();
      going = port ? this.#connect(port) : this.choose();
    } finally {
      this.#beginning.value = false;
    }
    await going;
  }

  /** Lets the pilot choose a port in the browser's own dialog. Call it from a click. */
  choose(): Promise<void> {
    return this.#link.choose(this.settings.value ?? undefined);
  }

  /** Notes that a port is one of this page, with a simulated timer or a recording behind it. */
  simulate(port: SerialPortLike): SerialPortLike {
    this.#simulated.add(port);
    return port;
  }

  #connect(port: SerialPortLike): Promise<void> {
    const settings = this.#simulated.has(port) ? { ...DEFAULT_SETTINGS, baudRate: 9600 } : this.settings.value;
    return this.#link.connect(port, settings ?? undefined);
  }

  /** Ends any connection or attempt, and closes the port. */
  stop(): Promise<void> {
    return this.#link.stop();
  }

  /** The timer no longer answers: asks quietly until it does. */
  wait(): void {
    this.#link.wait();
  }

  /** The computer has slept: checks whether the timer is still there. */
  recheck(): void {
    this.#link.recheck();
  }

  /** Gives the permission for a port back to the browser, and forgets what is remembered of it. */
  async forget({ port, key }: KnownPort): Promise<void> {
    await this.#link.forget(port);
    this.#records.value = new Map([...this.#records.peek()].filter(([known]) => known !== key));
    await this.#options.ports.remove(key).catch(() => {});
    await this.refresh();
  }

  /** Accepts what the pilot says about the connected timer, and remembers it as a first guess for the next time. */
  async assume(quirks: AssumedQuirks): Promise<void> {
    const connection = this.connection.value;
    if (!connection) return;
    connection.client.assume(quirks);
    await this.remember();
  }

  /** Stores what a job has found out about the timer, if anything. */
  async learn(): Promise<void> {
    if (this.connection.value?.client.quirksAssumed !== this.#quirksKept) await this.remember();
  }

  /** Stores what this connection has taught: settings, rate, quirks. */
  async remember(): Promise<void> {
    const connection = this.connection.value;
    if (!connection || this.simulated.value) return;
    const { identity, client, settings } = connection;
    this.#quirksKept = client.quirksAssumed;
    await this.#learning;
    const before = this.#records.peek().get(connection.portKey);
    const record: PortRecord = {
      key: connection.portKey,
      usedAt: Date.now(),
      settings: this.settings.value ?? before?.settings ?? DEFAULT_SETTINGS,
      foundRate: settings.baudRate,
      quirks: { ...before?.quirks, [kindKey(identity, false)]: { ...client.quirksAssumed } },
    };
    this.#put(record);
    // Where the browser keeps nothing, this is lost, too; the drafts report it.
    await this.#options.ports.save(record).catch(() => {});
  }

  /**
   * Forgets all assumptions about timers of this kind on this port, also for the connected one if it is of that kind.
   */
  async forgetAssumed({ client, identity, portKey }: TimerConnection): Promise<void> {
    const kind = kindKey(identity, false);
    client.forgetQuirks();
    await this.#learning;
    const record = this.#records.peek().get(portKey);
    if (!record) return;
    const quirks = Object.fromEntries(Object.entries(record.quirks).filter(([known]) => known !== kind));
    this.#put({ ...record, quirks });
    await this.#options.ports.save({ ...record, quirks }).catch(() => {});
  }

  #put(record: PortRecord): void {
    this.#records.value = new Map(this.#records.peek()).set(record.key, record);
  }

  #remembered(key: string): RememberedPort | undefined {
    const record = this.#records.peek().get(key);
    return record && { settings: record.settings, knownRate: record.foundRate ?? undefined };
  }

  #follow(state: LinkState): void {
    const before = this.state.value;
    this.#state.value = state;
    this.#onState(state, before);
  }
}

/** The information of the port with which the link deals; null for none. */
export function portInfoOf(state: LinkState): PortInfo | null {
  if ('info' in state) return state.info;
  return 'port' in state ? state.port.getInfo() : null;
}
