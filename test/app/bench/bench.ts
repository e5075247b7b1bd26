import { onTestFinished, vi } from 'vitest';
import type { TabChannel } from '../../../src/app/browser/other-tabs.js';
import { platformOf } from '../../../src/app/browser/platform.js';
import { type Locks, TabNumber } from '../../../src/app/browser/tab-number.js';
import { plugRecording } from '../../../src/app/connect/simulated-timer.js';
import { createModels, type ModelOptions } from '../../../src/app/models.js';
import {
  type AsideRecord,
  type Backup,
  type Draft,
  type Exchange,
  type FlightRecord,
  isSame,
  type Keeper,
  type ModelRecord,
  type PortRecord,
  type SettingRecord,
  SHELVES,
  type Storage,
  type Unfinished,
} from '../../../src/app/storage/index.js';
// Here before it is asked for: time stands still in these tests.
import '../../../src/app/session/recognition-rule.js';
import { MockSerial } from '../../../src/mock-serial/index.js';
import { Adapter, type TimerOptions } from '../../serial/bench.js';

/** Keeps records as long as the test lasts, in the place of a shelf of the browser's storage. */
class MemoryShelf<T extends { readonly key: string }> implements Keeper<T> {
  readonly records = new Map<string, T>();
  readonly #store: MemoryStore;

  constructor(store: MemoryStore) {
    this.#store = store;
  }

  async save(record: T): Promise<void> {
    this.#store.touch();
    this.records.set(record.key, structuredClone(record));
  }

  async exchange({ record, known }: Exchange<T>): Promise<T | null> {
    this.#store.touch();
    const held = this.records.get(record.key);
    if (held && ![record, ...known].some((each) => isSame(each, held))) return structuredClone(held);
    await this.save(record);
    return null;
  }

  async remove(key: string): Promise<void> {
    this.#store.touch();
    this.records.delete(key);
  }

  async load(key: string): Promise<T | undefined> {
    this.#store.touch();
    return this.records.get(key);
  }

  async all(): Promise<T[]> {
    this.#store.touch();
    return [...this.records.values()];
  }
}

/** The browser's storage. The same one again stands for a reload. */
export class MemoryStore implements Storage {
  readonly drafts = new MemoryShelf<Draft>(this);
  readonly unfinished = new MemoryShelf<Unfinished>(this);
  readonly backups = new MemoryShelf<Backup>(this);
  readonly ports = new MemoryShelf<PortRecord>(this);
  readonly aside = new MemoryShelf<AsideRecord>(this);
  readonly models = new MemoryShelf<ModelRecord>(this);
  readonly settings = new MemoryShelf<SettingRecord>(this);
  readonly flights = new MemoryShelf<FlightRecord>(this);
  /** As in a browser whose storage is full or switched off. */
  broken = false;

  async erase(): Promise<void> {
    this.touch();
    for (const shelf of SHELVES) this[shelf].records.clear();
  }

  touch(): void {
    if (this.broken) throw new DOMException('The storage is full.', 'QuotaExceededError');
  }
}

/** The locks of a browser with one tab. */
const ALONE: Locks = { request: async (_, __, work) => work({}) };

export interface BenchOptions extends TimerOptions, Partial<Pick<ModelOptions, 'erasers' | 'reload' | 'platform'>> {
  /** Default: a new one. The same one again stands for a reload. */
  readonly store?: MemoryStore;
  /** Whether this browser has Web Serial. Default true. */
  readonly webSerial?: boolean;
  /** Between this page and other tabs of it. Default: none. */
  readonly channel?: TabChannel;
  /** Default: the only one. */
  readonly tab?: TabNumber;
  /** False: the page is left as it is before anything was asked of the browser. Default true. */
  readonly started?: boolean;
}

/** Everything of the app but its screen, before a timer that is not there. Time is turned by {@link run} alone. */
export async function appBench({
  store = new MemoryStore(),
  webSerial = true,
  channel,
  tab,
  started = true,
  erasers,
  reload,
  platform = platformOf({ userAgent: '' }),
  ...timer
}: BenchOptions = {}) {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] });
  onTestFinished(() => void vi.useRealTimers());
  const serial = new MockSerial({ userActivation: true });
  const options: TimerOptions = { identity: { timerClass: 'Q' }, ...timer };
  const adapter = new Adapter(serial, { ...options, plug: { granted: false, ...timer.plug } });
  serial.choose(adapter.port);
  const models = createModels({
    surroundings: { serial: webSerial ? serial : undefined, isSecureContext: true },
    storage: store,
    tab: tab ?? new TabNumber(ALONE, { load: () => null, save: () => {} }),
    plugSimulated: (timerClass) => new Adapter(new MockSerial(), { identity: { timerClass } }).port,
    plugRecording,
    platform,
    channel: channel ?? null,
    erasers,
    reload,
  });
  const { session } = models;
  if (started) await session.keptWork.start();
  return {
    ...models,
    models,
    serial,
    adapter,
    port: adapter.port,
    timer: adapter.timer,
    store,
    editor: session.editor,
  };
}

export type AppBench = Awaited<ReturnType<typeof appBench>>;

/** A bench on which the pilot has connected and read. */
export async function connectedBench(options: BenchOptions = {}): Promise<AppBench> {
  const bench = await appBench(options);
  await run(bench.session.timer.connect());
  return bench;
}

/**
 * The page is loaded anew, in the middle of whatever it was doing: the same storage, the same timer as it is now,
 * awake.
 */
export async function reloaded({ store, timer: { core } }: AppBench): Promise<AppBench> {
  const { identity } = core;
  // A new clock: the page that is gone does nothing more.
  const bench = await appBench({ store, identity, plug: { granted: true } });
  bench.timer.core.memories.splice(0, core.memories.length, ...structuredClone(core.memories));
  bench.timer.core.memory = core.memory;
  return bench;
}

/** Turns the clock from appointment to appointment until the promise settles. */
export async function run<T>(promise: Promise<T>): Promise<T> {
  let settled = false;
  const done = (): void => {
    settled = true;
  };
  promise.then(done, done);
  await vi.advanceTimersByTimeAsync(0);
  while (!settled) {
    // What an appointment has set off may make another one a little later.
    if (vi.getTimerCount() === 0) await vi.advanceTimersByTimeAsync(0);
    if (vi.getTimerCount() === 0 && !settled)
      throw new Error('Nothing is due on the clock, and the promise has not settled.');
    if (!settled) await vi.advanceTimersToNextTimerAsync();
  }
  return promise;
}

/**
 * Lets everything happen that is under way: more time than any job takes, while what waits for ever goes on waiting.
 */
export async function idle(ms = 20_000): Promise<void> {
  await vi.advanceTimersByTimeAsync(ms);
}
