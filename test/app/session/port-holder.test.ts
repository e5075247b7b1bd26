import { describe, expect, it } from 'vitest';
import type { TabChannel } from '../../../src/app/browser/other-tabs.js';
import { type AppBench, appBench, connectedBench, idle, run } from '../bench/bench.js';

/** The channel between the tabs of one browser: hands a copy to every other one, a little later. */
function browser(): () => TabChannel {
  const listeners = new Map<TabChannel, (event: { data: unknown }) => void>();
  return () => {
    const channel: TabChannel = {
      postMessage: (message) => {
        const data = structuredClone(message);
        for (const [other, listener] of listeners) {
          if (other !== channel) setTimeout(() => listener({ data }), 1);
        }
      },
      addEventListener: (_, listener) => void listeners.set(channel, listener),
      close: () => void listeners.delete(channel),
    };
    return channel;
  };
}

const info = { usbVendorId: 0x0403, usbProductId: 0x6001 };

/** One tab that is connected, and another one that cannot have the port. */
async function twoTabs(): Promise<{ first: AppBench; second: AppBench }> {
  const channel = browser();
  // Each has a port object of its own for the one adapter, as two tabs have.
  const first = await appBench({ channel: channel(), info });
  const second = await appBench({ channel: channel(), info });
  await run(first.session.timer.connect());
  second.port.device.busy = true;
  first.session.link.state.subscribe(({ status }) => {
    second.port.device.busy = status !== 'off';
  });
  const connecting = second.session.timer.connect();
  await idle();
  await connecting;
  await idle(1000);
  return { first, second };
}

function status({ session }: AppBench): string {
  return session.link.state.value.status;
}

describe('a port that another tab holds', () => {
  it('is named with what that tab shows', async () => {
    const { first, second } = await twoTabs();
    expect([status(first), status(second), second.session.notices.current.value?.code]).toEqual(['on', 'off', 'busy']);
    expect(second.portHolder.tab.value).toMatchObject({ what: 'F1Q, M1', writing: false });
    expect(first.portHolder.tab.value).toBeNull();
  });

  it('is taken over: the other tab releases it and says so, and this one connects', async () => {
    const { first, second } = await twoTabs();
    first.editor.type({ kind: 'position', servo: 0, slot: 2 }, '7');
    const { value: holder } = second.portHolder.tab;
    if (!holder) throw new Error('no holder was found');
    const taking = second.portHolder.takeOver(holder);
    await idle();
    expect(await taking).toBe('released');
    expect([status(first), first.session.notices.current.value?.code, first.port.device.opened]).toEqual([
      'off',
      'taken-over',
      null,
    ]);
    expect(
      first.editor.textOf({ kind: 'position', servo: 0, slot: 2 }),
      'the first tab still shows what was typed',
    ).toBe('7');
    expect([status(second), second.session.notices.current.value, second.portHolder.tab.value]).toEqual([
      'on',
      null,
      null,
    ]);
    expect(second.editor.working.value?.times[10]).toBe(18000);
  });

  it('is not taken over in the middle of a write', async () => {
    const { first, second } = await twoTabs();
    first.editor.type({ kind: 'position', servo: 0, slot: 2 }, '7');
    await run(first.write.open());
    first.session.safety.confirm();
    let taking: Promise<unknown> = Promise.resolve();
    first.timer.core.onAnswer = ({ name }) => {
      const { value: holder } = second.portHolder.tab;
      if (name !== 'SETSERVO' || !holder) return;
      first.timer.core.sleep();
      taking = second.portHolder.takeOver(holder);
    };
    const writing = first.write.start();
    await idle(100);
    expect(first.write.current.value?.step).toBe('running');
    expect(await run(taking)).toBe('writing');
    expect([status(first), status(second)]).toEqual(['on', 'off']);
    first.timer.core.press();
    await run(writing);
    expect(first.write.current.value).toMatchObject({ report: { result: 'verified' } });
  });
});

describe('a tab without others', () => {
  it('says only that the port is in use', async () => {
    const bench = await connectedBench({ channel: browser()(), info });
    await run(bench.session.timer.disconnect());
    bench.port.device.busy = true;
    const connecting = bench.session.timer.connect();
    await idle();
    await connecting;
    await idle(1000);
    expect([bench.session.notices.current.value?.code, bench.portHolder.tab.value]).toEqual(['busy', null]);
  });
});
