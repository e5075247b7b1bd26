import { beforeEach, describe, expect, it, onTestFinished, vi } from 'vitest';
import { limited } from '../../src/app/storage/index.js';
import { StorageError, type StorageErrorCode, within } from '../../src/app/storage/limit.js';
import { MemoryStore } from './bench.js';

beforeEach(() => {
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  onTestFinished(() => void vi.useRealTimers());
});

/** What a promise has come to so far. */
function watched(promise: Promise<unknown>): { said: unknown } {
  const seen: { said: unknown } = { said: 'open' };
  promise.then(
    (value) => Object.assign(seen, { said: value }),
    (error) => Object.assign(seen, { said: error instanceof StorageError ? error.code : error }),
  );
  return seen;
}

describe('what the storage is asked for', () => {
  it('is given as it comes, and no clock runs on', async () => {
    expect(await within(Promise.resolve(7))).toBe(7);
    expect(await within(async () => 8)).toBe(8);
    expect(vi.getTimerCount()).toBe(0);
  });

  it('has five seconds, or as long as is said', async () => {
    const usual = watched(within(new Promise(() => {})));
    const short = watched(within(() => new Promise(() => {}), 100));
    await vi.advanceTimersByTimeAsync(99);
    expect([usual.said, short.said]).toEqual(['open', 'open']);
    await vi.advanceTimersByTimeAsync(1);
    expect([usual.said, short.said]).toEqual(['open', 'slow']);
    await vi.advanceTimersByTimeAsync(4899);
    expect(usual.said).toBe('open');
    await vi.advanceTimersByTimeAsync(1);
    expect(usual.said).toBe('slow');
  });

  it.each<[what: string, settle: (resolve: () => void, reject: (error: Error) => void) => void]>([
    ['comes', (resolve) => resolve()],
    ['fails', (_, reject) => reject(new Error('late'))],
  ])('is passed over when it %s later', async (_, settle) => {
    let end = (): void => {};
    const work = new Promise<void>((resolve, reject) => {
      end = () => settle(resolve, reject);
    });
    const late = watched(within(work, 10));
    await vi.advanceTimersByTimeAsync(10);
    end();
    await vi.advanceTimersByTimeAsync(0);
    expect(late.said).toBe('slow');
  });

  it.each<[StorageErrorCode, unknown]>([
    ['full', new DOMException('no room', 'QuotaExceededError')],
    ['newer', new DOMException('version 9', 'VersionError')],
    ['missing', new DOMException('not here', 'SecurityError')],
    ['missing', new ReferenceError('indexedDB is not defined')],
    ['blocked', new StorageError('blocked', 'another tab')],
    ['failed', new DOMException('the disk', 'UnknownError')],
    ['failed', 'a text'],
  ])('fails by code: %s', async (code, cause) => {
    const rejected = await within(Promise.reject(cause)).catch((error) => error);
    const thrown = await within(() => {
      throw cause;
    }).catch((error) => error);
    expect([rejected, thrown]).toMatchObject([{ code }, { code }]);
    expect(rejected).toBeInstanceOf(StorageError);
    expect(vi.getTimerCount()).toBe(0);
  });
});

it('every call of every shelf of the storage goes through it', async () => {
  const store = new MemoryStore();
  const storage = limited(store, { answered: () => {}, failed: () => {} });
  expect(Object.keys(storage), 'all shelves').toEqual(Object.keys(store).filter((key) => key !== 'broken'));
  for (const [name, shelf] of Object.entries(storage)) {
    for (const call of ['save', 'remove', 'load', 'all'] as const) {
      const spy = vi.spyOn(store[name as keyof typeof storage], call).mockReturnValue(new Promise<never>(() => {}));
      const said = watched(shelf[call]({ key: 'a' } as never));
      await vi.advanceTimersByTimeAsync(5000);
      expect([said.said, spy.mock.calls.length], `${name}.${call}`).toEqual(['slow', 1]);
    }
  }
});
