import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { DEFAULT_SETTINGS, type LinkState, type SerialLike, TimerLink } from '../../src/serial/index.js';
import { B536 } from '../protocol/vectors.js';
import { canBeOpened, failure } from './bench.js';
import { connectionOf, linkBench, on, sent, slowChooser, way } from './link-bench.js';

describe('wait()', () => {
  it('asks quietly on the open port until the timer answers, as a new connection', async () => {
    const { clock, link, timer, port, states } = await on();
    const before = connectionOf(link);
    let opened = 0;
    port.device.onopenchange = () => opened++;
    timer.core.sleep();
    link.wait();
    expect(link.state).toEqual({ status: 'waiting', port, baudRate: 9600, heard: null });
    await clock.advance(2500);
    expect(opened, 'the port is neither closed nor opened again').toBe(0);
    timer.core.press();
    await clock.advance(2000);
    expect(way(states)).toBe('waiting > on');
    expect(connectionOf(link).client).not.toBe(before.client);
    expect(await failure(before.client.identify())).toMatchObject({ code: 'closed' });
  });
});

describe('recheck()', () => {
  it('reports nothing when the timer is there', async () => {
    const { clock, link, states, line } = await on();
    const before = connectionOf(link);
    await clock.run(link.recheck());
    expect(states).toEqual([]);
    expect(connectionOf(link)).toBe(before);
    expect(sent(line)).toEqual(['GETSWVER']);
  });

  it('waits for the running job', async () => {
    const { clock, link, states, line } = await on({ plug: { timing: true } });
    const reading = connectionOf(link).client.readProgram();
    await clock.advance(5);
    await clock.run(link.recheck());
    expect((await clock.run(reading)).identity).toEqual(B536);
    expect(states).toEqual([]);
    expect(sent(line).at(-1)).toBe('GETSWVER');
  });

  it('waits for a timer that has fallen asleep', async () => {
    const { clock, link, timer, states } = await on();
    timer.core.sleep();
    await clock.run(link.recheck());
    timer.core.press();
    await clock.advance(2000);
    expect(way(states)).toBe('waiting > on');
  });

  it('keeps the connection when everything is damaged, because somebody is there', async () => {
    let damage = 0;
    const toPage = (byte: number) => [byte ^ damage];
    const { clock, link, states } = await on({ plug: { fault: { toPage } } });
    damage = 0x11;
    await clock.run(link.recheck());
    expect(states).toEqual([]);
  });

  it('gives another timer a new connection', async () => {
    const { clock, link, timer, states } = await on();
    const before = connectionOf(link);
    Object.assign(timer.core.identity, { firmware: '600' });
    await clock.run(link.recheck());
    await clock.advance(0);
    expect(way(states)).toBe('searching > on');
    expect(connectionOf(link).identity.firmware).toBe('600');
    expect(connectionOf(link).client).not.toBe(before.client);
  });

  it('notices a port that failed while nobody looked', async () => {
    const { clock, link, port, states } = await on();
    port.device.failNextWrite('lost');
    await clock.run(link.recheck());
    await clock.advance(1000);
    expect(way(states)).toBe('away > opening > searching > on');
  });

  it('looks at once for an unplugged port', async () => {
    const { clock, link, adapter } = await on();
    adapter.unplug();
    await clock.advance(3500);
    // The computer slept, and nobody heard of it.
    adapter.port.dispatchEvent = () => true;
    adapter.replug({ samePort: true });
    await clock.advance(100);
    expect(link.state.status).toBe('away');
    await clock.run(link.recheck());
    await clock.advance(100);
    expect(link.state.status).toBe('on');
  });
});

describe('a signal given to connect()', () => {
  it('gives the attempt up: the port is closed, and the link off', async () => {
    const { clock, link, timer, port, states } = linkBench();
    timer.core.sleep();
    const given = new AbortController();
    const connecting = link.connect(port, undefined, { signal: given.signal });
    await clock.advance(100);
    expect(link.state.status).toBe('searching');
    given.abort();
    await clock.run(connecting);
    expect(way(states).endsWith('closing > off')).toBe(true);
    expect(await canBeOpened(port)).toBe(true);
  });

  it('gives it up while the connection before still ends', async () => {
    const { clock, link, port } = await on();
    const given = new AbortController();
    const connecting = link.connect(port, undefined, { signal: given.signal });
    given.abort();
    await clock.run(connecting);
    expect(link.state).toEqual({ status: 'off', error: null });
  });

  it('changes nothing once the link has settled, once another call has taken over, or when it was aborted before', async () => {
    const { clock, link, port } = linkBench();
    const [first, second] = [new AbortController(), new AbortController()];
    const superseded = link.connect(port, undefined, { signal: first.signal });
    const connecting = link.connect(port, undefined, { signal: second.signal });
    first.abort();
    await clock.run(Promise.all([superseded, connecting]));
    const connection = connectionOf(link);
    second.abort();
    await clock.run(link.connect(port, undefined, { signal: second.signal }));
    expect(connectionOf(link)).toBe(connection);
  });
});

describe('stop()', () => {
  it('is what `await using` does at the end of a block', async () => {
    const { clock, link } = await on();
    await clock.run(link[Symbol.asyncDispose]());
    expect(link.state.status).toBe('off');
  });

  it('lets the running request end, and the port can be opened at once', async () => {
    const { clock, link, port, timer } = await on({ plug: { timing: true } });
    const reading = failure(connectionOf(link).client.readProgram());
    await clock.advance(5);
    await clock.run(link.stop());
    expect(await reading).toMatchObject({ code: 'closed' });
    expect(timer.core.answered.map(({ name }) => name)).toEqual(['GETSWVER', 'GETMEMORY']);
    expect(await canBeOpened(port)).toBe(true);
  });

  it('takes no time while the port is unplugged', async () => {
    const { clock, link, adapter } = await on();
    adapter.unplug();
    await clock.advance(1000);
    const begin = clock.now();
    await clock.run(link.stop());
    expect(clock.now()).toBe(begin);
  });

  it('leaves no timer of the clock and no listener behind', async () => {
    const { clock, link, adapter, serial, port } = linkBench();
    const added = [serial, port].map((target) => vi.spyOn(target, 'addEventListener'));
    const removed = [serial, port].map((target) => vi.spyOn(target, 'removeEventListener'));
    const calls = (spies: readonly { mock: { calls: unknown[] } }[]) => spies.flatMap(({ mock }) => mock.calls).length;
    await clock.run(link.connect(port));
    adapter.unplug();
    await clock.advance(1000);
    adapter.replug({ samePort: true });
    await clock.advance(1000);
    expect(link.state.status).toBe('on');
    expect(calls(added) - calls(removed), 'one listener waits for the next loss, and no more').toBe(1);
    await clock.run(link.stop());
    expect(calls(added)).toBe(calls(removed));
    const end = clock.now();
    await expect(clock.run(new Promise(() => {}))).rejects.toThrow('Nothing is due');
    expect(clock.now()).toBe(end);
  });

  it('gives way to a later call', async () => {
    const { clock, link, port, states } = await on();
    const stopping = link.stop();
    await clock.run(link.connect(port));
    await stopping;
    expect(way(states)).toBe('closing > opening > searching > on');
  });

  it('ends although a port never closes', async () => {
    const { clock, link, port } = await on();
    port.close = () => new Promise(() => {});
    const begin = clock.now();
    await clock.run(link.stop());
    expect(clock.now() - begin).toBe(3000);
    expect(link.state.status).toBe('off');
  });

  it.each(['open', 'setSignals'] as const)('ends although %s() of a port never settles', async (method) => {
    const { clock, link, port, states } = linkBench();
    port[method] = () => new Promise(() => {});
    const connecting = link.connect(port, { ...DEFAULT_SETTINGS, dtr: true });
    await clock.advance(60_000);
    expect(way(states)).toBe('opening');
    const begin = clock.now();
    await clock.run(link.stop());
    expect(clock.now() - begin).toBe(3000);
    expect(link.state.status).toBe('off');
    await connecting;
    expect(port.device.opened).toBeNull();
  });

  it('ends the wait for a lost port, in a browser that never says which ports it has', async () => {
    const { clock, link, adapter, serial } = await on();
    serial.getPorts = () => new Promise(() => {});
    adapter.unplug();
    await clock.advance(10_000);
    expect(link.state.status).toBe('away');
    await clock.run(link.stop());
    expect(link.state.status).toBe('off');
  });

  it('closes a port that opens after it was given up, and can connect to it then', async () => {
    const { clock, link, port, states } = linkBench();
    const open = port.open.bind(port);
    let answer = (): void => {};
    port.open = async (options) => {
      await new Promise<void>((resolve) => {
        answer = resolve;
      });
      await open(options);
    };
    void link.connect(port);
    await clock.advance(1000);
    await clock.run(link.stop());
    answer();
    await clock.advance(0);
    expect(port.device.opened).toBeNull();
    port.open = open;
    await clock.run(link.connect(port));
    expect(way(states)).toBe('opening > closing > off > opening > searching > on');
  });

  it('closes a port that never takes the bytes it is given', async () => {
    const { clock, link, port, states } = linkBench();
    const stuck = new WritableStream<Uint8Array>({ write: () => new Promise(() => {}) });
    const close = port.close.bind(port);
    Object.defineProperty(port, 'writable', { value: stuck });
    port.close = async () => {
      // As the standard has it.
      if (stuck.locked) throw new TypeError('Cannot close the port while its writable is locked.');
      await close();
    };
    await clock.run(link.connect(port));
    expect(way(states)).toBe('opening > searching > waiting');
    await clock.run(link.stop());
    expect(port.device.opened).toBeNull();
  });

  it('may be called while any state is reported', async () => {
    for (const at of ['opening', 'searching', 'waiting', 'on', 'away'] as const) {
      const { clock, port, adapter, timer } = linkBench();
      if (at === 'waiting') timer.core.sleep();
      const states: LinkState[] = [];
      const link: TimerLink = new TimerLink({
        clock,
        onState: (state) => {
          states.push(state);
          if (state.status === at) void link.stop();
        },
      });
      void link.connect(port);
      await clock.advance(10_000);
      adapter.unplug();
      await clock.advance(10_000);
      expect(
        way(states).endsWith(`${at} > closing > off`),
        `the link must close and end off, but it went ${way(states)}`,
      ).toBe(true);
      adapter.replug({ samePort: true });
      expect(await canBeOpened(port)).toBe(true);
    }
  });
});

describe('choose()', () => {
  it('asks without filters: adapters of every kind are offered', async () => {
    const { clock, link, serial } = linkBench();
    const asked = vi.spyOn(serial, 'requestPort');
    await clock.run(link.choose());
    expect(asked.mock.calls).toEqual([[]]);
  });

  it('keeps the connection when nothing is chosen', async () => {
    const { serial, link, states } = await on();
    serial.choose(null);
    await link.choose();
    expect(states).toEqual([]);
    expect(link.state.status).toBe('on');
  });

  it('follows only the last of two choosers', async () => {
    const chooser = slowChooser();
    const { link, clock, port, states } = linkBench({ link: { serial: chooser } });
    const first = link.choose();
    const { answer } = chooser;
    void link.choose();
    answer(null);
    await first;
    expect(way(states)).toBe('choosing');
    chooser.answer(port);
    await clock.advance(1000);
    expect(way(states)).toBe('choosing > opening > searching > on');
  });

  it('ignores the chooser when the link is stopped or connects in another way', async () => {
    for (const wish of ['stop', 'connect'] as const) {
      const chooser = slowChooser();
      const { link, clock, port, states } = linkBench({ link: { serial: chooser } });
      void link.choose();
      await clock.run(link[wish](port));
      const { length } = states;
      chooser.answer(port);
      await clock.advance(1000);
      expect(states).toHaveLength(length);
    }
  });

  it('does not wait while the link is closing', async () => {
    const chooser = slowChooser();
    const { link, clock, port, states } = await on({ link: { serial: chooser } });
    const stopping = link.stop();
    void link.choose();
    await clock.run(stopping);
    expect(way(states)).toBe('closing > off');
    chooser.answer(port);
    await clock.advance(1000);
    expect(way(states)).toBe('closing > off > opening > searching > on');
  });

  it.each([
    [undefined, 'not-allowed'],
    [true, 'not-allowed'],
    [false, 'policy'],
  ] as const)('says why the browser refuses where the policy allows: %s', async (policyAllows, code) => {
    const { serial } = linkBench();
    serial.userActivation = false;
    const states: LinkState[] = [];
    const link = new TimerLink({ serial, policyAllows, onState: (state) => states.push(state) });
    await link.choose();
    expect(way(states)).toBe(`choosing > off (${code})`);
  });
});

describe('the ports', () => {
  it('are those that were allowed and are plugged in, with their names', async () => {
    const { link, serial, port } = linkBench();
    serial.plug();
    serial.unplug(serial.plug({}, { granted: true }));
    const ports = await link.ports();
    expect(ports).toEqual([{ port, kind: 'ftdi', key: 'usb:0403:6001', info: port.getInfo() }]);
    expect(ports[0]?.port).toBe(port);
  });

  it('are not those that a browser lists although they are gone', async () => {
    const ports = [false, true, undefined].map((connected) => ({ connected, getInfo: () => ({}) }));
    const serial = { getPorts: async () => ports } as never;
    expect((await new TimerLink({ serial }).ports()).map(({ port }) => port)).toEqual(ports.slice(1));
  });

  it('are refused where a policy forbids them', async () => {
    const serial: SerialLike = {
      getPorts: () => Promise.reject(new DOMException('Blocked.', 'SecurityError')),
      requestPort: () => Promise.reject(new DOMException('Blocked.', 'SecurityError')),
    };
    await expect(new TimerLink({ serial, policyAllows: false }).ports()).rejects.toMatchObject({ code: 'policy' });
  });

  it('can be forgotten, which ends a link to them', async () => {
    const { link, clock, port, states } = await on();
    await clock.run(link.forget(port));
    expect(way(states)).toBe('closing > off');
    expect(await link.ports()).toEqual([]);
  });

  it('can be forgotten without ending a link to another', async () => {
    const { link, clock, serial, states } = await on();
    await clock.run(link.forget(serial.plug({}, { granted: true })));
    expect(states).toEqual([]);
    expect(await link.ports()).toHaveLength(1);
  });

  it('stay where the browser cannot forget', async () => {
    const { link, clock, port } = await on();
    Object.assign(port, { forget: undefined });
    await clock.run(link.forget(port));
    expect(link.state.status).toBe('off');
  });
});

describe('a callback that throws', () => {
  it('is reported, and does not disturb the link', async () => {
    const reported = vi.fn();
    vi.stubGlobal('reportError', reported);
    onTestFinished(() => void vi.unstubAllGlobals());
    const trouble = new Error('the trouble of the consumer');
    const fail = (): never => {
      throw trouble;
    };
    const { clock, serial, port } = linkBench();
    const link = new TimerLink({ serial, clock, onLine: fail, onState: fail, remembered: fail, assumed: fail });
    await clock.run(link.connect(port));
    expect(connectionOf(link).identity).toEqual(B536);
    await clock.run(link.stop());
    expect(link.state).toEqual({ status: 'off', error: null });
    expect(await canBeOpened(port)).toBe(true);
    expect(new Set(reported.mock.calls.flat())).toEqual(new Set([trouble]));
  });
});
