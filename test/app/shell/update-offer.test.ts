import { effect } from '@preact/signals';
import { render } from '@testing-library/preact';
import { h } from 'preact';
import { describe, expect, it, vi } from 'vitest';
import { type News, newsOfWaiting, newTo } from '../../../src/app/browser/update-news.js';
import { useUnsaved } from '../../../src/app/ui/unsaved.js';
import { MODEL } from '../../program/library-examples.js';
import { appBench, connectedBench, idle, run } from '../bench/bench.js';

const release = (version: string) => ({ version, changes: [{ title: 'Added', items: [`What ${version} brings`] }] });
/** What a version says that is two releases ahead: the page of a test calls itself unreleased. */
const NEWS: News = { version: '0.3.0', releases: ['0.3.0', '0.2.0', 'unreleased'].map(release) };

function Open() {
  useUnsaved();
  return null;
}

describe('a new version of the page', () => {
  it('waits only for an open port, and begins once when that is closed', async () => {
    const { session, update } = await connectedBench();
    const begin = vi.fn();
    update.whenFree(begin);
    await idle();
    expect([update.waitsFor.value, session.keptWork.kept.value, begin.mock.calls.length]).toEqual(['port', true, 0]);
    await run(session.timer.disconnect());
    await idle();
    expect([update.waitsFor.value, begin.mock.calls.length]).toEqual([null, 1]);
    await run(session.timer.connect());
    await run(session.timer.disconnect());
    await idle();
    expect(begin).toHaveBeenCalledOnce();
  });

  it('waits for a port that is being opened, too', async () => {
    const { session, update } = await appBench();
    void session.timer.connect();
    await idle(0);
    expect([session.link.state.value.status, update.waitsFor.value]).toEqual(['searching', 'port']);
  });

  it('begins at once where nothing is open and nothing typed would be lost', async () => {
    const { update } = await appBench();
    const begin = vi.fn();
    update.whenFree(begin);
    await idle(0);
    expect(begin).toHaveBeenCalledOnce();
  });

  it('waits for what a reload would lose: what the library has not kept, and what is open', async () => {
    const { session, store, update } = await appBench();
    const begin = vi.fn();
    store.broken = true;
    await session.library.keepModel(MODEL);
    update.whenFree(begin);
    await idle();
    expect([update.waitsFor.value, begin.mock.calls.length]).toEqual(['edits', 0]);
    const { unmount } = render(h(Open, {}));
    store.broken = false;
    await session.library.keepAgain();
    await idle();
    expect([update.waitsFor.value, begin.mock.calls.length]).toEqual(['open', 0]);
    unmount();
    await idle();
    expect([update.waitsFor.value, begin.mock.calls.length]).toEqual([null, 1]);
  });

  it('does not begin when something is opened at the same moment', async () => {
    const { session, update } = await connectedBench();
    const begin = vi.fn();
    update.whenFree(begin);
    effect(() => {
      if (session.link.state.value.status === 'off') void session.timer.connect();
    });
    await run(session.timer.disconnect());
    await idle();
    expect([session.link.state.value.status, begin.mock.calls.length]).toEqual(['on', 0]);
  });

  it('is offered with its version and news as soon as it has sent them', async () => {
    const { update } = await appBench();
    update.offer(() => {}, Promise.resolve(NEWS));
    expect([update.version.value, update.releases.value]).toEqual([null, []]);
    await idle(0);
    expect(update.version.value).toBe('0.3.0');
    expect(update.releases.value.map((release) => release.version)).toEqual(['0.3.0', '0.2.0']);
  });

  it('is no longer offered when a newer one has replaced it', async () => {
    const { update } = await appBench();
    let tell = (_: News): void => {};
    update.offer(() => {}, new Promise((resolve) => (tell = resolve)));
    update.offer(() => {}, Promise.resolve(null));
    tell(NEWS);
    await idle(0);
    expect(update.version.value).toBeNull();
  });

  it('is accepted once, also when a newer one replaces it meanwhile', async () => {
    const { update } = await connectedBench();
    const took = vi.fn();
    update.offer(took);
    update.read(true);
    update.take.value?.();
    expect([took.mock.calls.length, update.take.value, update.taken.value, update.reading.value]).toEqual([
      1,
      null,
      true,
      false,
    ]);
    update.offer(took);
    expect(update.take.value).toBeNull();
  });
});

describe('what is new in a version that waits', () => {
  /** A worker that answers so. */
  const worker = (answer: (port: MessagePort) => void) => ({
    postMessage: (_: unknown, [port]: readonly MessagePort[]) => port && answer(port),
  });

  it('is sent by its worker', async () => {
    expect(await newsOfWaiting(worker((port) => port.postMessage(NEWS)) as never)).toEqual(NEWS);
  });

  it.each([
    ['says nothing', () => {}],
    ['says something else', (port: MessagePort) => port.postMessage({ version: 3, releases: 'many' })],
    ['says far too much', (port: MessagePort) => port.postMessage({ ...NEWS, version: 'x'.repeat(2000) })],
    [
      'is gone',
      () => {
        throw new DOMException('gone', 'InvalidStateError');
      },
    ],
  ])('is not known of one that %s', async (_, answer) => {
    vi.useFakeTimers({ toFake: ['setTimeout', 'clearTimeout'] });
    const told = newsOfWaiting(worker(answer) as never);
    await new Promise((resolve) => setImmediate(resolve));
    await vi.advanceTimersByTimeAsync(3000);
    vi.useRealTimers();
    expect(await told).toBeNull();
  });

  it('is at least the newest release, also for a page of that release', () => {
    expect(newTo('0.3.0', NEWS).map(({ version }) => version)).toEqual(['0.3.0']);
    expect(newTo('0.2.0', NEWS).map(({ version }) => version)).toEqual(['0.3.0']);
    expect(newTo('0.0.1', NEWS).map(({ version }) => version)).toEqual(['0.3.0', '0.2.0', 'unreleased']);
  });
});
