import { effect } from '@preact/signals';
import { render } from '@testing-library/preact';
import { h } from 'preact';
import { describe, expect, it, vi } from 'vitest';
import { useUnsaved } from '../../../src/app/ui/unsaved.js';
import { MODEL } from '../../program/library-examples.js';
import { appBench, connectedBench, idle, run } from '../bench/bench.js';

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
    expect([update.free.value, session.drafts.kept.value, begin.mock.calls.length]).toEqual([false, true, 0]);
    await run(session.timer.disconnect());
    await idle();
    expect([update.free.value, begin.mock.calls.length]).toEqual([true, 1]);
    await run(session.timer.connect());
    await run(session.timer.disconnect());
    await idle();
    expect(begin).toHaveBeenCalledOnce();
  });

  it('waits for a port that is being opened, too', async () => {
    const { session, update } = await appBench();
    void session.timer.connect();
    await idle(0);
    expect([session.link.state.value.status, update.free.value]).toEqual(['searching', false]);
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
    expect([update.free.value, begin.mock.calls.length]).toEqual([false, 0]);
    const { unmount } = render(h(Open, {}));
    store.broken = false;
    await session.library.keepAgain();
    await idle();
    expect([update.free.value, begin.mock.calls.length]).toEqual([false, 0]);
    unmount();
    await idle();
    expect([update.free.value, begin.mock.calls.length]).toEqual([true, 1]);
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

  it('is accepted once, also when a newer one replaces it meanwhile', async () => {
    const { update } = await connectedBench();
    const took = vi.fn();
    update.offer(took);
    update.take.value?.();
    expect([took.mock.calls.length, update.take.value, update.taken.value]).toEqual([1, null, true]);
    update.offer(took);
    expect(update.take.value).toBeNull();
  });
});
