import { beforeEach, describe, expect, it, vi } from 'vitest';
import { attempt, NoAnswer } from '../../../src/app/browser/services.js';
import { limited, SHELF_CALLS, SHELVES } from '../../../src/app/storage/index.js';
import { MemoryStore } from '../bench/bench.js';

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
});

/** What a promise has come to so far. */
function watched(promise: Promise<unknown>): { said: unknown } {
  const seen: { said: unknown } = { said: 'open' };
  promise.then(
    (value) => Object.assign(seen, { said: value }),
    (error) => Object.assign(seen, { said: error instanceof NoAnswer ? 'slow' : error }),
  );
  return seen;
}

describe('an attempt', () => {
  it('gives the answer or the error of the browser, and no clock keeps running', async () => {
    expect(await attempt(async () => 8)).toBe(8);
    const no = new TypeError('no');
    expect(await attempt(() => Promise.reject(no)).catch((error) => error)).toBe(no);
    const thrown = attempt(() => {
      throw no;
    });
    expect(await thrown.catch((error) => error)).toBe(no);
    expect(vi.getTimerCount()).toBe(0);
  });

  it('has three seconds, or the given time', async () => {
    const usual = watched(attempt(() => new Promise(() => {})));
    const short = watched(attempt(() => new Promise(() => {}), 100));
    await vi.advanceTimersByTimeAsync(99);
    expect([usual.said, short.said]).toEqual(['open', 'open']);
    await vi.advanceTimersByTimeAsync(1);
    expect([usual.said, short.said]).toEqual(['open', 'slow']);
    await vi.advanceTimersByTimeAsync(2899);
    expect(usual.said).toBe('open');
    await vi.advanceTimersByTimeAsync(1);
    expect(usual.said).toBe('slow');
  });

  it.each<[what: string, settle: (resolve: () => void, reject: (error: Error) => void) => void]>([
    ['comes', (resolve) => resolve()],
    ['fails', (_, reject) => reject(new Error('late'))],
  ])('is over when its answer %s later', async (_, settle) => {
    let end = (): void => {};
    const late = watched(
      attempt(() => new Promise<void>((resolve, reject) => (end = () => settle(resolve, reject))), 10),
    );
    await vi.advanceTimersByTimeAsync(10);
    end();
    await vi.advanceTimersByTimeAsync(0);
    expect(late.said).toBe('slow');
  });
});

it('every call of every shelf of the storage goes through it', async () => {
  const store = new MemoryStore();
  const storage = limited(store, { heard: () => {} });
  expect(Object.keys(storage), 'every shelf goes through the limit').toEqual([...SHELVES, 'change', 'erase']);
  for (const shelf of SHELVES) {
    expect(Object.keys(storage[shelf])).toEqual(Object.keys(SHELF_CALLS));
    for (const call of Object.keys(SHELF_CALLS) as (keyof typeof SHELF_CALLS)[]) {
      const calls = store[shelf] as Record<typeof call, (given: never) => unknown>;
      const spy = vi.spyOn(calls, call).mockReturnValue(new Promise<never>(() => {}));
      const said = watched(limited(store, { heard: () => {} })[shelf][call]({ key: 'a' } as never));
      await vi.advanceTimersByTimeAsync(5000);
      expect(
        [said.said, spy.mock.calls.length],
        `a call without an answer must be called slow: ${shelf}.${call}`,
      ).toEqual(['slow', 1]);
    }
  }
  store.change = () => new Promise(() => {});
  const said = watched(storage.change({}));
  await vi.advanceTimersByTimeAsync(5000);
  expect(said.said).toBe('slow');
});

it('after one without an answer, the next ones wait only briefly until one answers', async () => {
  const store = new MemoryStore();
  const told: unknown[] = [];
  const { drafts } = limited(store, { heard: (_, kind, kept) => told.push(kept ? kind : kept) });
  const spy = vi.spyOn(store.drafts, 'all').mockReturnValue(new Promise(() => {}));
  const first = watched(drafts.all());
  await vi.advanceTimersByTimeAsync(4999);
  expect(told).toEqual([]);
  await vi.advanceTimersByTimeAsync(1);
  expect(told).toEqual([null]);
  const second = watched(drafts.all());
  await vi.advanceTimersByTimeAsync(250);
  expect([first.said, second.said]).toEqual(['slow', 'slow']);
  spy.mockRestore();
  expect(await drafts.all()).toEqual([]);
  expect(told.at(-1)).toBe('read');
  vi.spyOn(store.drafts, 'all').mockReturnValue(new Promise(() => {}));
  const third = watched(drafts.all());
  await vi.advanceTimersByTimeAsync(4999);
  expect(third.said).toBe('open');
});
