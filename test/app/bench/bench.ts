import { expect, vi } from 'vitest';
import { platformOf } from '../../../src/app/browser/platform.js';
import { plugRecording } from '../../../src/app/connect/simulated-timer.js';
import { setValues } from '../../../src/app/editing/edit.js';
import { createModels, type ModelOptions } from '../../../src/app/models.js';
import {
  type AsideRecord,
  type Backup,
  type Draft,
  type FlightRecord,
  type Keeper,
  type LibraryChange,
  type ModelRecord,
  type PortRecord,
  type SettingRecord,
  SHELVES,
  type Storage,
  type Unfinished,
} from '../../../src/app/storage/index.js';
import type { Plan } from '../../../src/app/write/plan.js';
import { MockSerial } from '../../../src/mock-serial/index.js';
import type { ProgramField } from '../../../src/program/index.js';
import { Adapter, type TimerOptions } from '../../serial/bench.js';

/** Keeps records during the test, in place of a shelf of the browser's storage. */
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

  async remove(key: string): Promise<void> {
    this.#store.touch();
    this.records.delete(key);
  }

  async all(): Promise<T[]> {
    this.#store.touch();
    return [...this.records.values()];
  }
}

/** The browser's storage. Used again, it stands for a reload. */
export class MemoryStore implements Storage {
  readonly drafts = new MemoryShelf<Draft>(this);
  readonly unfinished = new MemoryShelf<Unfinished>(this);
  readonly backups = new MemoryShelf<Backup>(this);
  readonly ports = new MemoryShelf<PortRecord>(this);
  readonly aside = new MemoryShelf<AsideRecord>(this);
  readonly models = new MemoryShelf<ModelRecord>(this);
  readonly settings = new MemoryShelf<SettingRecord>(this);
  readonly flights = new MemoryShelf<FlightRecord>(this);
  /** Whether it fails, like the storage of a browser that is full or switched off. */
  broken = false;

  async change(change: LibraryChange): Promise<void> {
    this.touch();
    for (const shelf of ['models', 'settings', 'flights'] as const) {
      const { put = [], gone = [] } = change[shelf] ?? {};
      for (const key of gone) this[shelf].records.delete(key);
      for (const record of put) this[shelf].records.set(record.key, structuredClone(record) as never);
    }
  }

  async erase(): Promise<void> {
    this.touch();
    for (const shelf of SHELVES) this[shelf].records.clear();
  }

  touch(): void {
    if (this.broken) throw new DOMException('The storage is full.', 'QuotaExceededError');
  }
}

export interface BenchOptions extends TimerOptions, Partial<Pick<ModelOptions, 'erasers' | 'reload' | 'platform'>> {
  /** Default: a new one. Used again, it stands for a reload. */
  readonly store?: MemoryStore;
  /** Whether this browser has Web Serial. Default true. */
  readonly webSerial?: boolean;
  /** False leaves the page as it is before it asks the browser for anything. Default true. */
  readonly started?: boolean;
}

/** Everything of the page but its screen, with a virtual timer. Only {@link run} and {@link idle} turn the time. */
export async function appBench({
  store = new MemoryStore(),
  webSerial = true,
  started = true,
  erasers,
  reload,
  platform = platformOf({ userAgent: '' }),
  ...timer
}: BenchOptions = {}) {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] });
  const serial = new MockSerial({ userActivation: true });
  const options: TimerOptions = { identity: { timerClass: 'Q' }, ...timer };
  const adapter = new Adapter(serial, { ...options, plug: { granted: false, ...timer.plug } });
  serial.choose(adapter.port);
  const models = createModels({
    surroundings: { serial: webSerial ? serial : undefined, isSecureContext: true },
    storage: store,
    plugSimulated: (timerClass) => new Adapter(new MockSerial(), { identity: { timerClass } }).port,
    plugRecording,
    platform,
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

/** A bench after the pilot has connected and read. */
export async function connectedBench(options: BenchOptions = {}): Promise<AppBench> {
  const bench = await appBench(options);
  await run(bench.session.timer.connect());
  return bench;
}

/** The same, and the pilot has said that it is safe. */
export async function safeBench(options: BenchOptions = {}): Promise<AppBench> {
  const app = await connectedBench(options);
  app.session.safety.confirm();
  app.timer.core.answered.length = 0;
  return app;
}

/** Servos that follow. @param at where they were moved to before. */
export async function following(options: BenchOptions = {}, at = 4): Promise<AppBench> {
  const app = await safeBench(options);
  await run(app.bench.moveTo(at));
  await run(app.follow.start());
  expect(app.follow.on.value).toBe(true);
  app.timer.core.answered.length = 0;
  return app;
}

/** Changes these values in one step. */
export function set({ editor }: AppBench, ...values: [ProgramField, number][]): void {
  const edits = values.map(([field, value]) => ({ field, value }));
  editor.apply(setValues({ code: 'change', params: {} }, edits));
}

/**
 * Loads the page again, in the middle of whatever it was doing: with the same storage, and the same timer in its
 * present state, awake.
 */
export async function reloaded({ store, timer: { core } }: AppBench): Promise<AppBench> {
  const { identity } = core;
  // A new clock, so that the old page does nothing more.
  const bench = await appBench({ store, identity, plug: { granted: true } });
  bench.timer.core.memories.splice(0, core.memories.length, ...structuredClone(core.memories));
  bench.timer.core.memory = core.memory;
  return bench;
}

/** Turns the clock from callback to callback until the promise settles. */
export async function run<T>(promise: Promise<T>): Promise<T> {
  let settled = false;
  const done = (): void => {
    settled = true;
  };
  promise.then(done, done);
  await vi.advanceTimersByTimeAsync(0);
  while (!settled) {
    // A callback may have set another one that comes a little later.
    if (vi.getTimerCount() === 0) await vi.advanceTimersByTimeAsync(0);
    if (vi.getTimerCount() === 0 && !settled)
      throw new Error('Nothing is due on the clock, and the promise has not settled.');
    if (!settled) await vi.advanceTimersToNextTimerAsync();
  }
  return promise;
}

/** Opens the dialog of a write, until it asks something or is gone. */
export async function review(app: Pick<AppBench, 'write' | 'session'>, plan?: Plan): Promise<void> {
  void app.write.open(plan);
  await asked(app);
}

/** The pilot goes on in the dialog of a write, until it asks something or is gone. */
export async function goOn(app: Pick<AppBench, 'write' | 'session'>): Promise<void> {
  app.write.goOn();
  await asked(app);
}

/** Turns the clock until a write asks the pilot something, or is at its end. */
export async function asked({ write, session: { runner } }: Pick<AppBench, 'write' | 'session'>): Promise<void> {
  do {
    await run(runner.still());
    await idle(0);
  } while (!runner.job.value?.asking && (runner.job.value || write.current.value?.step === 'running'));
}

/** Lets everything happen that is in progress: more time than any job takes. What waits for ever goes on waiting. */
export async function idle(ms = 20_000): Promise<void> {
  await vi.advanceTimersByTimeAsync(ms);
}

/** What was sent to write or to select something, by name and in order. */
export function sets({ timer }: AppBench): string[] {
  return timer.core.answered.map(({ name }) => name).filter((name) => name.startsWith('SET'));
}

/** The memories that were selected, in order. */
export function selected({ timer }: AppBench): number[] {
  return timer.core.answered.flatMap((request) => (request.name === 'SETMEMORY' ? [request.memory] : []));
}
