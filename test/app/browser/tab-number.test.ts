import { beforeEach, describe, expect, it, onTestFinished, vi } from 'vitest';
import { type Locks, TabNumber } from '../../../src/app/browser/tab-number.js';
import { type AppBench, appBench, type BenchOptions, idle, MemoryStore, run } from '../bench/bench.js';

const S1 = { kind: 'position', servo: 0, slot: 2 } as const;

/** One tab of a browser: what it holds and what it remembers. */
interface Tab {
  /** The page that is in it, or the one after a reload. */
  page(): TabNumber;
  /** The page is gone. */
  close(): void;
  /** Another tab that remembers the same. */
  copy(): Tab;
}

/** The locks between the tabs of one browser. Given out in the order in which they were asked for, a little later. */
function browser(): () => Tab {
  const held = new Map<string, object>();
  const queue = new Set<() => void>();
  const look = (): void => {
    for (const each of queue) each();
    queue.clear();
  };
  const open = (remembered: number | null): Tab => {
    let memory = remembered;
    let page = {};
    const locks: Locks = {
      request: async (name, options, work) => {
        const owner = page;
        await Promise.resolve();
        if (held.has(name) && 'ifAvailable' in options) return work(null);
        while (held.has(name) && 'signal' in options) {
          await new Promise<void>((resolve, reject) => {
            queue.add(resolve);
            options.signal.addEventListener('abort', () => reject(options.signal.reason));
          });
        }
        held.set(name, owner);
        await work({});
        if (held.get(name) === owner) held.delete(name);
        look();
      },
    };
    const save = (number: number): void => {
      memory = number;
    };
    return {
      page: () => {
        page = {};
        return new TabNumber(locks, { load: () => memory, save });
      },
      close: () => {
        for (const [name, owner] of held) if (owner === page) held.delete(name);
        look();
      },
      copy: () => open(memory),
    };
  };
  return () => open(null);
}

beforeEach(() => {
  localStorage.clear();
  vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
  onTestFinished(() => void vi.useRealTimers());
});

async function taken(page: TabNumber): Promise<number> {
  await page.takeBefore();
  await page.takeAny();
  return page.value;
}

describe('the number of a tab', () => {
  it('is the lowest that no other tab has', async () => {
    const newTab = browser();
    const [first, second, third] = [newTab(), newTab(), newTab()];
    expect([await taken(first.page()), await taken(second.page()), await taken(third.page())]).toEqual([1, 2, 3]);
    second.close();
    expect(await taken(newTab().page())).toBe(2);
  });

  it('stays what it is', async () => {
    const newTab = browser();
    await taken(newTab().page());
    const page = newTab().page();
    expect([await taken(page), await page.take(1), await page.take(2)]).toEqual([2, false, true]);
    expect([await page.take(3), page.value], 'the number stays, also when another one is free').toEqual([false, 2]);
    await page.takeAny();
    expect(page.value).toBe(2);
  });

  it('is free while no other tab has it, also at the second question', async () => {
    const newTab = browser();
    const [first, second] = [newTab().page(), newTab().page()];
    await taken(first);
    await taken(second);
    expect([await first.isFree(1), await first.isFree(2), await first.isFree(3)]).toEqual([false, false, true]);
    expect(await second.isFree(3)).toBe(true);
  });

  it('is the same after a reload, also when a lower one has become free', async () => {
    const newTab = browser();
    const [first, second] = [newTab(), newTab()];
    await taken(first.page());
    await taken(second.page());
    first.close();
    second.close();
    expect(await taken(second.page())).toBe(2);
  });

  it('is waited for after a reload until the old page releases it', async () => {
    const newTab = browser();
    const tab = newTab();
    await taken(tab.page());
    const next = taken(tab.copy().page());
    await vi.advanceTimersByTimeAsync(500);
    tab.close();
    expect(await next).toBe(1);
  });

  it('differs in the copy of a tab', async () => {
    const tab = browser()();
    await taken(tab.page());
    const page = tab.copy().page();
    const before = page.takeBefore();
    await vi.advanceTimersByTimeAsync(1000);
    await before;
    await page.takeAny();
    expect(page.value).toBe(2);
  });

  it.each([
    ['has no locks', null],
    ['refuses them', { request: () => Promise.reject(new DOMException('Not here.', 'SecurityError')) }],
  ])('is 1 in a browser that %s', async (_, locks) => {
    const page = new TabNumber(locks, { load: () => 2, save: () => {} });
    expect(await taken(page)).toBe(1);
  });
});

describe.each([
  ['simulated', (bench: AppBench) => bench.session.timer.trySimulated('Q')],
  ['real', (bench: AppBench) => bench.session.timer.connect()],
])('two tabs with a %s timer', (_, connect) => {
  async function trying(options: BenchOptions): Promise<AppBench> {
    const bench = await appBench({ ...options, plug: { granted: true } });
    await run(connect(bench));
    return bench;
  }
  const notice = ({ session }: AppBench): string | undefined => session.notices.current.value?.code;

  it('keep their own edits, also over a reload', async () => {
    const [newTab, store] = [browser(), new MemoryStore()];
    const tabs = [newTab(), newTab()] as const;
    const first = await trying({ store, tab: tabs[0].page() });
    first.editor.type(S1, '7');
    await idle();
    const second = await trying({ store, tab: tabs[1].page() });
    expect([notice(second), second.editor.textOf(S1)], 'the second tab shows no edits of the first').toEqual([
      undefined,
      '35',
    ]);
    second.editor.type(S1, '8');
    await idle();
    for (const [i, text] of ['7', '8'].entries()) {
      const tab = tabs[i];
      tab?.close();
      const again = await appBench({ store, plug: { granted: true }, ...(tab && { tab: tab.page() }) });
      expect([notice(again), again.editor.textOf(S1)]).toEqual(['edits-restored', text]);
      await run(connect(again));
      expect(again.editor.textOf(S1)).toBe(text);
    }
  });

  it('leave what was typed in a closed tab to the next one', async () => {
    const [newTab, store] = [browser(), new MemoryStore()];
    const tabs = [newTab(), newTab()] as const;
    for (const [i, tab] of tabs.entries()) {
      const bench = await trying({ store, tab: tab.page() });
      bench.editor.type(S1, `${7 + i}`);
      await idle();
    }
    tabs[1].close();
    const next = await appBench({ store, tab: newTab().page() });
    expect([notice(next), next.editor.textOf(S1)]).toEqual(['edits-restored', '8']);
    const other = await appBench({ store, tab: newTab().page() });
    expect([notice(other), other.editor.working.value]).toEqual([undefined, null]);
  });

  it('leave it to the next tab also when the browser removes the closed one late', async () => {
    const [newTab, store] = [browser(), new MemoryStore()];
    const tabs = [newTab(), newTab()] as const;
    (await trying({ store, tab: tabs[0].page() })).editor.type(S1, '7');
    await idle();
    const next = await appBench({ store, tab: tabs[1].page() });
    await idle(8000);
    expect(next.editor.working.value, 'the closed tab still counts as open, so its edits are not taken').toBeNull();
    tabs[0].close();
    await idle();
    expect([notice(next), next.editor.textOf(S1)]).toEqual(['edits-restored', '7']);
    expect([...store.drafts.records.values()].map((draft) => draft.tab)).toEqual([2]);
  });

  it('do not give it to a tab that has its own edits by then', async () => {
    const [newTab, store] = [browser(), new MemoryStore()];
    const tabs = [newTab(), newTab()] as const;
    (await trying({ store, tab: tabs[0].page() })).editor.type(S1, '7');
    await idle(500);
    const other = await trying({ store, tab: tabs[1].page() });
    other.editor.type(S1, '9');
    await run(other.session.reader.selectMemory(1));
    await run(other.session.timer.disconnect());
    tabs[0].close();
    await idle();
    // It still shows the memory that it has read last, and nothing of the other tab.
    expect([notice(other), other.editor.working.value?.memory]).toEqual([undefined, 1]);
    expect(other.editor.dirty.value).toBe(false);
    const typed = [...store.drafts.records.values()].map(({ tab, working }) => [tab, working.positions[0]?.[2]]);
    expect(typed).toEqual([
      [1, 7],
      [2, 9],
    ]);
  });

  it('keep it through a reload, also when another tab waits for a timer', async () => {
    const [newTab, store] = [browser(), new MemoryStore()];
    const tab = newTab();
    (await trying({ store, tab: tab.page() })).editor.type(S1, '7');
    await idle();
    const other = await appBench({ store, tab: newTab().page() });
    tab.close();
    await idle(2000);
    const again = await appBench({ store, tab: tab.page() });
    await idle();
    expect([notice(again), again.editor.textOf(S1)]).toEqual(['edits-restored', '7']);
    expect([notice(other), other.editor.working.value]).toEqual([undefined, null]);
  });

  it('also leave it to an open tab that reads such a timer, and then only that tab has it', async () => {
    const [newTab, store] = [browser(), new MemoryStore()];
    const [tab, left] = [newTab(), newTab()];
    const bench = await appBench({ store, plug: { granted: true }, tab: tab.page() });
    const gone = await trying({ store, tab: left.page() });
    gone.editor.type(S1, '8');
    await idle();
    left.close();
    await run(connect(bench));
    expect([notice(bench), bench.editor.textOf(S1)]).toEqual(['edits-kept', '8']);
    await idle();
    expect([...store.drafts.records.values()].map((draft) => draft.tab)).toEqual([1]);
  });

  it('keep their own trials on the bench', async () => {
    const [newTab, store] = [browser(), new MemoryStore()];
    const tabs = [newTab(), newTab()] as const;
    const benches = [await trying({ store, tab: tabs[0].page() }), await trying({ store, tab: tabs[1].page() })];
    const tried = ({ follow }: AppBench) => follow.trials.tried.value.map(({ to }) => to);
    for (const [i, { session, bench, follow, editor }] of benches.entries()) {
      session.safety.confirm();
      await run(bench.moveTo(2));
      await run(follow.start());
      editor.type(S1, `${7 + i}`);
      await idle();
    }
    expect(benches.map(tried)).toEqual([[7], [8]]);
    const kept = JSON.parse(localStorage.getItem('sidus-timer/trials') ?? '[]') as { key: string }[];
    expect(kept[1]?.key).toBe(`${kept[0]?.key}/2`);
    tabs[0].close();
    const again = await appBench({ store, tab: tabs[0].page() });
    expect(again.follow.trials.current.value?.before.positions[0]?.[2]).toBe(35);
  });
});

it('a tab that takes over the timer of another one continues with what was typed there', async () => {
  const [newTab, store, plug] = [browser(), new MemoryStore(), { granted: true }];
  const first = await appBench({ store, plug, tab: newTab().page() });
  await run(first.session.timer.connect());
  first.editor.type(S1, '7');
  await idle();
  const second = await appBench({ store, plug, tab: newTab().page() });
  await run(second.session.timer.connect());
  expect(second.editor.textOf(S1), 'the second tab is on another timer, so it shows no edits of the first').toBe('35');
  await run(second.session.timer.disconnect());
  await run(second.session.timer.takeOver());
  expect(second.editor.textOf(S1)).toBe('7');
  await idle();
  expect(
    [...store.drafts.records.values()].map((draft) => draft.tab),
    'the first tab keeps its draft, too',
  ).toEqual([1, 2]);
});
