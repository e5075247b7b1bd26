import { describe, expect, it, vi } from 'vitest';
import { appBench, connectedBench, idle, run } from '../bench/bench.js';

describe('a new version of the page', () => {
  it('waits for an open port alone, and begins once, when that is closed', async () => {
    const { session, update } = await connectedBench();
    const begin = vi.fn();
    update.whenFree(begin);
    await idle();
    expect([update.waitsFor.value, session.keptWork.kept.value, begin.mock.calls.length]).toEqual(['port', true, 0]);
    await run(session.disconnect());
    await idle();
    expect([update.waitsFor.value, begin.mock.calls.length]).toEqual([null, 1]);
    await run(session.connect());
    await run(session.disconnect());
    await idle();
    expect(begin).toHaveBeenCalledOnce();
  });

  it('waits for a port that is being opened, too', async () => {
    const { session, update } = await appBench();
    void session.connect();
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
});
