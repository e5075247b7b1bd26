import { onTestFinished, vi } from 'vitest';
import { Session } from '../../src/app/state/session.js';
import { WriteFlow } from '../../src/app/state/write-flow.js';
import type { Draft, DraftStore } from '../../src/app/storage/drafts.js';
import { MockSerial } from '../../src/mock-serial/index.js';
import { Adapter, type TimerOptions } from '../serial/bench.js';

/** Keeps drafts as long as the test lasts, in the place of the browser's storage. */
export class MemoryStore {
  readonly drafts = new Map<string, Draft>();
  /** As in a browser whose storage is full or switched off. */
  broken = false;

  async save(draft: Draft): Promise<void> {
    this.#touch();
    this.drafts.set(draft.key, structuredClone(draft));
  }

  async remove(key: string): Promise<void> {
    this.#touch();
    this.drafts.delete(key);
  }

  async load(key: string): Promise<Draft | undefined> {
    this.#touch();
    return this.drafts.get(key);
  }

  async newest(): Promise<Draft | undefined> {
    this.#touch();
    return [...this.drafts.values()].at(-1);
  }

  #touch(): void {
    if (this.broken) throw new DOMException('The storage is full.', 'QuotaExceededError');
  }
}

export interface BenchOptions extends TimerOptions {
  /** Default: a new one. The same one again stands for a reload. */
  readonly store?: MemoryStore;
  /** Whether this browser has Web Serial. Default true. */
  readonly webSerial?: boolean;
}

/** Everything of the app but its screen, before a timer that is not there. Time is turned by {@link run} alone. */
export async function appBench({ store = new MemoryStore(), webSerial = true, ...timer }: BenchOptions = {}) {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout', 'performance'] });
  onTestFinished(() => void vi.useRealTimers());
  const serial = new MockSerial({ userActivation: true });
  const options: TimerOptions = { identity: { timerClass: 'Q' }, ...timer };
  const adapter = new Adapter(serial, { ...options, plug: { granted: false, ...timer.plug } });
  serial.choose(adapter.port);
  const session = new Session({
    surroundings: { serial: webSerial ? serial : undefined, isSecureContext: true },
    // A class with private fields: nothing else has its type, though nothing else of it is used.
    store: store as unknown as DraftStore,
    plugSimulated: (timerClass) => new Adapter(new MockSerial(), { identity: { timerClass } }).port,
  });
  const write = new WriteFlow(session);
  await session.start();
  return { serial, adapter, port: adapter.port, timer: adapter.timer, store, session, editor: session.editor, write };
}

export type AppBench = Awaited<ReturnType<typeof appBench>>;

/** A bench on which the pilot has connected and read. */
export async function connectedBench(options: BenchOptions = {}): Promise<AppBench> {
  const bench = await appBench(options);
  await run(bench.session.connect());
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
    if (vi.getTimerCount() === 0) throw new Error('Nothing is due on the clock, and the promise has not settled.');
    await vi.advanceTimersToNextTimerAsync();
  }
  return promise;
}

/** Lets everything happen that is under way. */
export async function idle(): Promise<void> {
  await vi.runAllTimersAsync();
}
