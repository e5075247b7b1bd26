import { describe, expect, it, vi } from 'vitest';
import { type Locks, OneTab, type TabChannel } from '../../../src/app/browser/one-tab.js';

type Given = (lock: unknown) => Promise<unknown>;

/** A browser with one lock, and a channel between its tabs. */
function browser() {
  vi.useFakeTimers();
  const waiting: { readonly give: () => Promise<void>; readonly signal: AbortSignal | undefined }[] = [];
  let isHeld = false;
  const next = (): void => {
    const first = isHeld ? undefined : waiting.shift();
    if (!first) return;
    if (first.signal?.aborted) {
      next();
      return;
    }
    isHeld = true;
    void first.give().finally(() => {
      isHeld = false;
      next();
    });
  };
  const request = (_: string, { ifAvailable, signal }: LockOptions, work: Given): Promise<unknown> =>
    new Promise((resolve) => {
      if (ifAvailable && isHeld) return resolve(work(null));
      waiting.push({ give: async () => resolve(await work({})), signal });
      next();
    });
  const locks = { request } as unknown as Locks;
  const listeners = new Map<TabChannel, (event: { data: unknown }) => void>();
  /** Tabs whose process hangs. */
  const hung = new Set<TabChannel>();
  const open = (): TabChannel => {
    const channel: TabChannel = {
      postMessage: (message) => {
        for (const [other, listener] of listeners)
          if (other !== channel && !hung.has(other)) setTimeout(() => listener({ data: structuredClone(message) }), 1);
      },
      addEventListener: (_, listener) => void listeners.set(channel, listener),
    };
    return channel;
  };
  return {
    locks,
    /** A tab, and how it may begin. */
    async tab(): Promise<{ tab: OneTab; begun: string; hang: () => void; free: () => boolean }> {
      const channel = open();
      const tab = new OneTab(locks, () => channel);
      const beginning = tab.begin();
      await vi.advanceTimersByTimeAsync(2000);
      let isFree = false;
      void tab.free.then(() => {
        isFree = true;
      });
      return { tab, begun: await beginning, hang: () => void hung.add(channel), free: () => isFree };
    },
  };
}

/** A tab at work, whose page is gone 10 ms after it was asked, or after its job. */
function working({ tab }: { tab: OneTab }, busy: () => boolean = () => false) {
  const leave = vi.fn(async () => {
    while (busy()) await new Promise((resolve) => setTimeout(resolve, 100));
    await new Promise((resolve) => setTimeout(resolve, 10));
    tab.end();
  });
  tab.work(busy, leave);
  return leave;
}

describe('two tabs', () => {
  it('do not work at the same time; the second one knows since when the first is open', async () => {
    const { tab } = browser();
    const first = await tab();
    const since = Date.now();
    working(first);
    await vi.advanceTimersByTimeAsync(60_000);
    const second = await tab();
    expect([first.begun, second.begun, second.free()]).toEqual(['alone', 'other', false]);
    expect(second.tab.other.value).toMatchObject({ since, busy: false });
    expect(second.tab.silent.value).toBe(false);
  });

  it('change places when the second one asks', async () => {
    const { tab } = browser();
    const first = await tab();
    const leave = working(first);
    const second = await tab();
    second.tab.ask();
    await vi.advanceTimersByTimeAsync(20);
    expect([leave.mock.calls.length, second.free()]).toEqual([1, true]);
    expect((await tab()).begun).toBe('other');
  });

  it('change places only when the job of the first one has ended, however long that takes', async () => {
    const { tab } = browser();
    const first = await tab();
    let busy = true;
    const leave = working(first, () => busy);
    const second = await tab();
    second.tab.ask();
    for (let seconds = 0; seconds < 60; seconds++) {
      await vi.advanceTimersByTimeAsync(1000);
      expect([second.free(), second.tab.silent.value]).toEqual([false, false]);
    }
    expect(second.tab.other.value?.busy).toBe(true);
    busy = false;
    await vi.advanceTimersByTimeAsync(200);
    expect([second.free(), leave.mock.calls.length]).toEqual([true, 1]);
  });

  it('a first one that does not answer is said, and the second works when that is closed', async () => {
    const { tab } = browser();
    const first = await tab();
    working(first);
    first.hang();
    const second = await tab();
    expect([second.begun, second.tab.other.value]).toEqual(['other', null]);
    second.tab.ask();
    await vi.advanceTimersByTimeAsync(2900);
    expect(second.tab.silent.value).toBe(false);
    await vi.advanceTimersByTimeAsync(200);
    expect([second.tab.silent.value, second.free()]).toEqual([true, false]);
    first.tab.end();
    await vi.advanceTimersByTimeAsync(20);
    expect(second.free()).toBe(true);
  });

  it('a first one that hangs in the middle of a job is said, too', async () => {
    const { tab } = browser();
    const first = await tab();
    working(first, () => true);
    const second = await tab();
    second.tab.ask();
    await vi.advanceTimersByTimeAsync(100);
    first.hang();
    await vi.advanceTimersByTimeAsync(6100);
    expect(second.tab.silent.value).toBe(true);
  });
});

it('a page that is loaded again does not find itself in its way', async () => {
  const { tab, locks } = browser();
  const first = await tab();
  working(first);
  const next = new OneTab(locks, () => null);
  const beginning = next.begin();
  await vi.advanceTimersByTimeAsync(300);
  first.tab.end();
  expect(await beginning).toBe('alone');
});

describe('the page works where the browser', () => {
  it.each<[string, Locks | null]>([
    ['has no locks', null],
    ['never answers', { request: () => new Promise(() => {}) } as unknown as Locks],
    [
      'throws',
      {
        request: () => {
          throw new TypeError('not here');
        },
      } as unknown as Locks,
    ],
    ['refuses', { request: () => Promise.reject(new DOMException('Not here.', 'SecurityError')) } as unknown as Locks],
  ])('%s', async (_, locks) => {
    vi.useFakeTimers();
    const beginning = new OneTab(locks, () => null).begin();
    await vi.advanceTimersByTimeAsync(1000);
    expect(await beginning).toBe('unknown');
  });

  it('refuses a channel between its tabs', async () => {
    const { locks } = browser();
    const tab = new OneTab(locks, () => {
      throw new DOMException('Not here.', 'SecurityError');
    });
    expect(await tab.begin()).toBe('alone');
    tab.work(
      () => false,
      async () => {},
    );
  });
});
