import { fireEvent, render, screen } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import {
  type OtherTab,
  OtherTabs,
  openTabChannel,
  type TabChannel,
  type TabState,
  type TakeOver,
} from '../../../src/app/browser/other-tabs.js';
import { OtherTabNotice } from '../../../src/app/connect/other-tab-notice.js';
import { type Clock, VirtualClock } from '../../../src/line/index.js';

const PORT = 'usb 0403:6001';
const IDLE: TabState = { portKey: null, what: '', since: 0, writing: false };
const HOLDER: TabState = { portKey: PORT, what: 'F1Q, M2', since: 1000, writing: false };

/** One browser with tabs in it. Its channel hands a copy to every other tab, some milliseconds later. */
class FakeBrowser {
  readonly clock = new VirtualClock();
  /** Milliseconds that a message takes. */
  latency = 1;
  readonly said: unknown[] = [];
  readonly #listeners = new Map<TabChannel, (event: { data: unknown }) => void>();

  channel(): TabChannel {
    const channel: TabChannel = {
      postMessage: (message) => {
        if (!this.#listeners.has(channel)) throw new DOMException('The channel is closed.', 'InvalidStateError');
        const data = structuredClone(message);
        this.said.push(data);
        for (const [other, listener] of this.#listeners) {
          if (other !== channel) this.clock.after(this.latency, () => listener({ data }));
        }
      },
      addEventListener: (_, listener) => void this.#listeners.set(channel, listener),
      close: () => void this.#listeners.delete(channel),
    };
    return channel;
  }

  /** A tab that says this of itself; `release` is how it closes its port. */
  tab(state: TabState, release?: () => Promise<boolean>) {
    const tab = { state, asked: 0, tabs: null as unknown as OtherTabs };
    tab.tabs = new OtherTabs({
      channel: this.channel(),
      clock: this.clock,
      self: () => tab.state,
      onReleaseAsked: async () => {
        tab.asked++;
        if (release) return await release();
        tab.state = IDLE;
        return true;
      },
    });
    return tab;
  }

  /** A participant that says whatever it likes. */
  stranger(answer: (data: Record<string, unknown>) => unknown): void {
    const channel = this.channel();
    channel.addEventListener('message', ({ data }) => {
      const said = answer(data as Record<string, unknown>);
      if (said !== undefined) channel.postMessage(said);
    });
  }
}

/** A promise that is kept from outside. */
function deferred<T>() {
  let resolve = (_: T): void => {};
  const promise = new Promise<T>((keep) => {
    resolve = keep;
  });
  return { promise, resolve };
}

/** The one tab that holds the port. */
async function holder(browser: FakeBrowser, asking: OtherTabs): Promise<OtherTab> {
  const [only, ...more] = await browser.clock.run(asking.holders(PORT));
  expect(more).toEqual([]);
  return only as OtherTab;
}

describe('which other tab holds a port', () => {
  it('is none when there is no other tab, and when none holds this port', async () => {
    const browser = new FakeBrowser();
    const { tabs } = browser.tab(HOLDER);
    expect(await browser.clock.run(tabs.holders(PORT))).toEqual([]);
    browser.tab(IDLE);
    browser.tab({ ...HOLDER, portKey: 'usb 10c4:ea60' });
    expect(await browser.clock.run(tabs.holders(PORT))).toEqual([]);
  });

  it('is answered by each tab that holds it, with what is on its screen, the oldest first', async () => {
    const browser = new FakeBrowser();
    browser.tab({ portKey: PORT, what: 'F1B, M1', since: 2000, writing: true });
    browser.tab(HOLDER);
    const { tabs } = browser.tab(IDLE);
    const found = await browser.clock.run(tabs.holders(PORT));
    expect(found).toEqual([
      { id: expect.any(String), portKey: PORT, what: 'F1Q, M2', since: 1000, writing: false },
      { id: expect.any(String), portKey: PORT, what: 'F1B, M1', since: 2000, writing: true },
    ]);
    expect(found[0]?.id).not.toBe(found[1]?.id);
  });

  it('is known after 150 ms, without waiting for later answers', async () => {
    const browser = new FakeBrowser();
    browser.tab(HOLDER);
    const { tabs } = browser.tab(IDLE);
    browser.latency = 74;
    expect(await browser.clock.run(tabs.holders(PORT))).toHaveLength(1);
    expect(browser.clock.now()).toBe(150);
    browser.latency = 76;
    expect(await browser.clock.run(tabs.holders(PORT))).toEqual([]);
  });

  it('can be asked by two tabs at once, and neither gets the answers to the other', async () => {
    const browser = new FakeBrowser();
    browser.tab(HOLDER);
    const first = browser.tab(IDLE).tabs;
    const second = browser.tab({ ...HOLDER, since: 3000 }).tabs;
    const both = await browser.clock.run(Promise.all([first.holders(PORT), second.holders(PORT)]));
    expect(both.map((found) => found.map(({ since }) => since))).toEqual([[1000, 3000], [1000]]);
  });

  it('is none where the browser has no channel', async () => {
    const tabs = new OtherTabs({ channel: null, self: () => HOLDER, onReleaseAsked: async () => true });
    expect(await tabs.holders(PORT)).toEqual([]);
    expect(await tabs.takeOver({ ...HOLDER, portKey: PORT, id: '1' })).toBe('gone');
    tabs.close();
  });

  it('is not answered by a tab that has closed its channel', async () => {
    const browser = new FakeBrowser();
    browser.tab(HOLDER).tabs.close();
    const { tabs } = browser.tab(IDLE);
    expect(await browser.clock.run(tabs.holders(PORT))).toEqual([]);
    tabs.close();
    expect(await tabs.holders(PORT)).toEqual([]);
  });

  it.each<[string, (answer: Record<string, unknown>) => unknown]>([
    ['a text in place of an object', () => 'holds'],
    ['null', () => null],
    ['an unknown kind', (answer) => ({ ...answer, kind: 'sings' })],
    ['no time', ({ since: _, ...answer }) => answer],
    ['an impossible time', (answer) => ({ ...answer, since: Number.NaN })],
    ['a number in place of a text', (answer) => ({ ...answer, what: 5 })],
    ['a text that is far too long', (answer) => ({ ...answer, what: 'F'.repeat(201) })],
    ['an answer to another tab', (answer) => ({ ...answer, to: 'somebody' })],
    ['an answer to another question', (answer) => ({ ...answer, ask: 77 })],
  ])('is not believed from a message with %s', async (_, damage) => {
    const browser = new FakeBrowser();
    const answer = ({ from, ask }: Record<string, unknown>): Record<string, unknown> => {
      return { kind: 'holds', from: 'stranger', to: from, ask, portKey: PORT, what: 'F1E', since: 5, writing: false };
    };
    let say = damage;
    browser.stranger((question) => say(answer(question)));
    const { tabs } = browser.tab(IDLE);
    expect(await browser.clock.run(tabs.holders(PORT))).toEqual([]);
    say = (whole) => ({ ...whole, colour: 'red' });
    expect(await browser.clock.run(tabs.holders(PORT)), 'fields that a later version adds are ignored').toHaveLength(1);
  });

  it('is answered however long the text is', async () => {
    const browser = new FakeBrowser();
    browser.tab({ ...HOLDER, what: 'F'.repeat(500) });
    const { tabs } = browser.tab(IDLE);
    expect((await holder(browser, tabs)).what).toBe('F'.repeat(200));
  });
});

describe('taking a port over', () => {
  it('makes the other tab close it, and a third tab does nothing', async () => {
    const browser = new FakeBrowser();
    const other = browser.tab(HOLDER);
    const third = browser.tab({ ...HOLDER, portKey: 'usb 10c4:ea60' });
    const { tabs } = browser.tab(IDLE);
    expect(await browser.clock.run(tabs.takeOver(await holder(browser, tabs)))).toBe('released');
    expect([other.asked, third.asked]).toEqual([1, 0]);
    expect(await browser.clock.run(tabs.holders(PORT))).toEqual([]);
    await expect(browser.clock.run(new Promise(() => {}))).rejects.toThrow('Nothing is due');
    expect(browser.clock.now(), 'nothing waits any more').toBeLessThan(1000);
  });

  it('waits until the last request has ended there', async () => {
    const browser = new FakeBrowser();
    browser.tab(HOLDER, () => new Promise((resolve) => browser.clock.after(2000, () => resolve(true))));
    const { tabs } = browser.tab(IDLE);
    const tab = await holder(browser, tabs);
    const from = browser.clock.now();
    expect(await browser.clock.run(tabs.takeOver(tab))).toBe('released');
    expect(browser.clock.now() - from).toBe(2002);
  });

  it('does not disturb a write', async () => {
    const browser = new FakeBrowser();
    const other = browser.tab({ ...HOLDER, writing: true });
    const { tabs } = browser.tab(IDLE);
    const tab = await holder(browser, tabs);
    expect(tab.writing).toBe(true);
    expect(await browser.clock.run(tabs.takeOver(tab))).toBe('writing');
    expect(other.asked).toBe(0);
    other.state = HOLDER;
    expect(
      await browser.clock.run(tabs.takeOver(tab)),
      'the other tab releases the port once its write has ended',
    ).toBe('released');
  });

  it('does not disturb a write that has begun meanwhile', async () => {
    const browser = new FakeBrowser();
    browser.tab(HOLDER, async () => false);
    const { tabs } = browser.tab(IDLE);
    expect(await browser.clock.run(tabs.takeOver(await holder(browser, tabs)))).toBe('writing');
  });

  it('does not close another port that the tab uses by now', async () => {
    const browser = new FakeBrowser();
    const other = browser.tab(HOLDER);
    const { tabs } = browser.tab(IDLE);
    const tab = await holder(browser, tabs);
    other.state = { ...HOLDER, portKey: 'usb 10c4:ea60' };
    expect(await browser.clock.run(tabs.takeOver(tab))).toBe('released');
    expect(other.asked).toBe(0);
  });

  it('gives up on a tab that was closed or does not answer within 3 s, and ignores a late answer', async () => {
    const browser = new FakeBrowser();
    const held = deferred<boolean>();
    const other = browser.tab(HOLDER, () => held.promise);
    const { tabs } = browser.tab(IDLE);
    const tab = await holder(browser, tabs);
    const from = browser.clock.now();
    expect(await browser.clock.run(tabs.takeOver(tab))).toBe('gone');
    expect(browser.clock.now() - from).toBe(3000);
    const again = tabs.takeOver(tab);
    other.state = { ...HOLDER, writing: true };
    held.resolve(true);
    expect(await browser.clock.run(again), 'the answer is that to the latest question').toBe('writing');
    other.tabs.close();
    expect(await browser.clock.run(tabs.takeOver(tab))).toBe('gone');
  });

  it('believes only the tab that was asked', async () => {
    const browser = new FakeBrowser();
    browser.tab(HOLDER, () => new Promise(() => {}));
    browser.stranger(({ kind, from, ask, portKey }) =>
      kind === 'release' ? { kind: 'answer', from: 'stranger', to: from, ask, portKey, result: 'released' } : undefined,
    );
    const { tabs } = browser.tab(IDLE);
    expect(await browser.clock.run(tabs.takeOver(await holder(browser, tabs)))).toBe('gone');
  });
});

describe('the channel of this browser', () => {
  it('carries questions and answers, also for a take-over', async () => {
    const open = (): TabChannel => openTabChannel() as TabChannel;
    /** Rings when told to. */
    let ring = (): void => {};
    const bell: Clock = {
      now: () => 0,
      after: (_, callback) => {
        ring = callback;
        return () => {};
      },
    };
    const other = new OtherTabs({ channel: open(), clock: bell, self: () => HOLDER, onReleaseAsked: async () => true });
    const asking = new OtherTabs({ channel: open(), clock: bell, self: () => IDLE, onReleaseAsked: async () => true });
    // Opened last, it hears everything after those two.
    const listener = open();
    listener.addEventListener('message', ({ data }) => (data as { kind: string }).kind === 'holds' && ring());
    const [tab] = await asking.holders(PORT);
    expect(tab).toMatchObject({ what: 'F1Q, M2', since: 1000, writing: false });
    expect(await asking.takeOver(tab as OtherTab)).toBe('released');
    for (const channel of [other, asking, listener]) channel.close();
  });
});

describe('the notice about another tab', () => {
  const since = new Date(2026, 4, 1, 9, 5).getTime();
  const tab: OtherTab = { ...HOLDER, id: '1', portKey: PORT, since };

  function shown(answer: () => Promise<TakeOver>, writing = false) {
    render(<OtherTabNotice tab={{ ...tab, writing }} onTakeOver={answer} onDismiss={() => {}} />);
    return screen.getByRole<HTMLButtonElement>('button', { name: 'Take over' });
  }

  it('says which it is and since when', () => {
    shown(async () => 'released');
    expect(screen.getByText('Another tab of this page holds the port: F1Q, M2, since 09:05.')).toBeTruthy();
  });

  it('says since when, also for a tab that has read no timer yet', () => {
    render(<OtherTabNotice tab={{ ...tab, what: '' }} onTakeOver={async () => 'released'} onDismiss={() => {}} />);
    expect(screen.getByText('Another tab of this page holds the port, since 09:05.')).toBeTruthy();
  });

  it.each<[TakeOver, RegExp]>([
    ['writing', /The other tab is writing\. Wait until it has finished\./],
    ['gone', /The other tab does not answer\. Close it, then press Connect again\./],
  ])('asks that tab once, and says so when it is %s', async (answer, sentence) => {
    let asked = 0;
    const given = deferred<TakeOver>();
    const button = shown(() => {
      asked++;
      return given.promise;
    });
    fireEvent.click(button);
    expect(await screen.findByText(/Asking the other tab/)).toBeTruthy();
    expect(button.disabled).toBe(true);
    given.resolve(answer);
    expect(await screen.findByText(sentence)).toBeTruthy();
    expect([asked, button.disabled]).toEqual([1, false]);
  });

  it('says at once that the tab writes, and the pilot can still try', () => {
    const button = shown(async () => 'released', true);
    expect(screen.getByText(/The other tab is writing\./)).toBeTruthy();
    expect(button.disabled).toBe(false);
  });
});
