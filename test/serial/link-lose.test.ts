import { describe, expect, it } from 'vitest';
import { type LinkState, type SerialLike, TimerLink } from '../../src/serial/index.js';
import { B536 } from '../protocol/vectors.js';
import { failure } from './bench.js';
import { connectionOf, type LinkBench, linkBench, on, portOf, way } from './link-bench.js';

describe('a loss', () => {
  const ways: readonly [string, (bench: LinkBench) => void, unplugged: boolean][] = [
    ['the plug is pulled', ({ adapter }) => adapter.unplug(), true],
    ['the stream fails', ({ port }) => port.device.error('lost'), false],
    ['the browser says so', ({ port }) => port.dispatchEvent(new Event('disconnect', { bubbles: true })), true],
    ['the site gives up its permission', ({ port }) => void port.forget(), false],
  ];

  it.each(ways)('is reported once when %s', async (_, lose, unplugged) => {
    const bench = await on();
    lose(bench);
    await bench.clock.advance(100);
    expect(bench.states).toEqual([
      {
        status: 'away',
        port: bench.port,
        info: bench.port.getInfo(),
        error: expect.objectContaining({ name: 'ConnectionError', code: 'lost' }),
        unplugged,
      },
    ]);
    expect(bench.port.device.opened, 'the port is closed').toBeNull();
  });

  it.each(ways)('is reported before the running request fails when %s', async (_, lose) => {
    const bench = await on({ plug: { timing: true } });
    const { link, clock } = bench;
    const told = failure(connectionOf(link).client.readProgram()).then((error) => ({ error, at: link.state.status }));
    await clock.advance(5);
    lose(bench);
    expect(await clock.run(told)).toMatchObject({ error: { name: 'TimerError' }, at: 'away' });
  });

  it.each(['says', 'does not say'])(
    'is reported as unplugged once that is known, in a browser that %s whether a port is connected',
    async (says) => {
      const { clock, adapter, port, states } = await on();
      if (says !== 'says') Object.defineProperty(port, 'connected', { value: undefined });
      port.device.error('lost');
      await clock.advance(50);
      adapter.unplug();
      await clock.advance(60_000);
      const told = states.map((state) => state.status === 'away' && state.unplugged);
      expect([way(states), told]).toEqual(['away', [false, true]]);
    },
  );

  it('at the moment in which the timer answers is noticed, and the link connects again', async () => {
    let lose = (): void => {};
    const { adapter, clock, connect, port, states } = linkBench({ link: { assumed: () => void lose() } });
    lose = () => {
      lose = () => {};
      adapter.unplug();
      port.dispatchEvent(new Event('disconnect', { bubbles: true }));
    };
    await connect();
    await clock.advance(1000);
    expect(way(states)).toBe('opening > searching > away');
    adapter.replug();
    await clock.advance(500);
    expect(way(states)).toBe('opening > searching > away > opening > searching > on');
  });

  it('during a job is not reported again when the job fails', async () => {
    const { link, clock, adapter, states } = await on();
    adapter.unplugAfter(20);
    await clock.run(failure(connectionOf(link).client.readProgram()));
    await clock.advance(60_000);
    expect(way(states)).toBe('away');
    expect(states).toHaveLength(1);
  });
});

describe('a port that returns', () => {
  it('is connected again in less than a second, at the rate that worked, with a new connection', async () => {
    const { link, clock, adapter, states, port } = await on({ answersAt: 38400, plug: { timing: true, latency: 20 } });
    const before = connectionOf(link);
    adapter.unplug();
    await clock.advance(300_000);
    adapter.replug();
    await clock.advance(500);
    const after = connectionOf(link);
    expect(after).not.toBe(before);
    expect(after.client).not.toBe(before.client);
    expect(after.settings.baudRate).toBe(38400);
    expect(states.filter(({ status }) => status === 'searching')).toMatchObject([{ baudRate: 38400 }]);
    expect((await clock.run(after.client.readProgram())).identity).toEqual(B536);
    expect(port.device.opened).not.toBeNull();
  });

  it.each(['the same', 'a new'])('comes back at once, however often in a row, as %s object', async (as) => {
    const { link, clock, adapter } = await on();
    for (let i = 0; i < 20; i++) {
      adapter.unplug();
      if (as === 'a new') adapter.returnAsNew();
      else adapter.replug();
      await clock.advance(150);
      expect(link.state.status, `the link did not come back after loss ${i + 1}`).toBe('on');
    }
  });

  it('comes back at once when its stream fails before the browser reports the unplugging', async () => {
    const { link, clock, adapter, port } = await on();
    for (let i = 0; i < 20; i++) {
      port.device.error('lost');
      await clock.advance(50);
      adapter.unplug();
      adapter.replug();
      await clock.advance(150);
      expect(link.state.status, `the link did not come back after loss ${i + 1}`).toBe('on');
    }
  });

  it('comes back at once when the browser reports the unplugging during the search for it', async () => {
    const { link, clock, adapter, port, serial } = await on();
    // A browser that says of no port whether it is connected, and takes its time to list them.
    Object.defineProperty(port, 'connected', { value: undefined });
    const { getPorts } = serial;
    serial.getPorts = async () => {
      const ports = await getPorts.call(serial);
      await new Promise<void>((resolve) => clock.after(50, resolve));
      return ports;
    };
    // Once more, and it would be given up.
    for (let i = 0; i < 5; i++) {
      port.device.error('lost');
      await clock.advance(9000);
    }
    for (let i = 0; i < 20; i++) {
      port.device.error('lost');
      await clock.advance(20);
      adapter.unplug();
      adapter.replug();
      await clock.advance(200);
      expect(link.state.status, `the link did not come back after loss ${i + 1}`).toBe('on');
    }
  });

  it('is not taken for another kind of adapter', async () => {
    const { link, clock, adapter, serial } = await on();
    adapter.unplug();
    await clock.advance(1000);
    serial.plug({ usbVendorId: 0x1a86, usbProductId: 0x7523 }, { granted: true });
    await clock.advance(10_000);
    expect(link.state.status).toBe('away');
  });

  it('is not taken for an adapter of the same kind that was there all the time', async () => {
    const { link, clock, adapter, serial } = linkBench();
    const twin = serial.plug(adapter.port.getInfo(), { granted: true });
    await clock.run(link.connect(adapter.port));
    adapter.unplug();
    await clock.advance(30_000);
    expect(link.state.status).toBe('away');
    serial.unplug(twin);
    await clock.advance(10_000);
    const again = serial.replug(twin);
    await clock.advance(1000);
    expect(portOf(link), 'the twin counts once it was plugged in again').toBe(again);
  });

  it('is noticed where there is only a port and no browser', async () => {
    const { link, clock, adapter } = await on({ link: { serial: undefined } });
    adapter.unplug();
    await clock.advance(3100);
    adapter.replug({ samePort: true });
    await clock.advance(100);
    expect(link.state.status).toBe('on');
  });

  it('is not opened when it is already gone again', async () => {
    const { link, clock, adapter, states } = await on();
    adapter.unplug();
    adapter.replug();
    adapter.unplug();
    await clock.advance(5000);
    expect(way(states)).toBe('away');
    adapter.replug();
    await clock.advance(100);
    expect(link.state.status).toBe('on');
  });

  it('is waited for again when it goes without an event while it is opened', async () => {
    const { clock, adapter, port, states } = await on();
    adapter.unplug();
    await clock.advance(1000);
    port.device.busy = true;
    adapter.replug();
    await clock.advance(1000);
    port.dispatchEvent = () => true;
    adapter.unplug();
    await clock.advance(2000);
    expect(way(states)).toBe('away > opening > away');
  });

  it.each(['the same', 'a new'])('is found within four seconds where there are no events, as %s object', async (as) => {
    const bench = linkBench();
    const deaf: SerialLike = { getPorts: () => bench.serial.getPorts(), requestPort: () => bench.serial.requestPort() };
    const states: LinkState[] = [];
    const link = new TimerLink({ serial: deaf, clock: bench.clock, onState: (state) => states.push(state) });
    Object.assign(bench.port, { addEventListener: () => {} });
    await bench.clock.run(link.connect(bench.port));
    bench.adapter.unplug();
    await bench.clock.advance(9000);
    expect(link.state.status).toBe('away');
    if (as === 'a new') bench.adapter.returnAsNew();
    else bench.adapter.replug();
    await bench.clock.advance(4000);
    expect(way(states)).toBe('opening > searching > on > away > opening > searching > on');
    await bench.clock.run(link.stop());
  });

  it('is found without events, although an adapter of the same kind was there all the time', async () => {
    const { clock, adapter, serial } = linkBench();
    const twin = serial.plug(adapter.port.getInfo(), { granted: true });
    const gone = serial.plug(adapter.port.getInfo(), { granted: true });
    const listed = [adapter.port, twin];
    const deaf: SerialLike = { getPorts: async () => [...listed], requestPort: () => serial.requestPort() };
    const states: LinkState[] = [];
    const link = new TimerLink({ serial: deaf, clock, onState: (state) => states.push(state) });
    await clock.run(link.connect(adapter.port));
    adapter.unplug();
    await clock.advance(4000);
    // Some browsers list what is not plugged in too.
    serial.unplug(gone);
    listed.splice(0, 2, gone);
    await clock.advance(4000);
    expect(link.state.status).toBe('away');
    listed.push(twin);
    await clock.advance(4000);
    expect(portOf(link)).toBe(twin);
    expect(way(states)).toBe('opening > searching > on > away > opening > searching');
    await clock.run(link.stop());
  });

  it('is found in a browser that does not say whether a port is connected', async () => {
    const { link, clock, adapter, port, connect, states } = linkBench();
    Object.defineProperty(port, 'connected', { value: undefined });
    await connect();
    adapter.unplug();
    await clock.advance(20_000);
    expect(way(states)).toBe('opening > searching > on > away');
    adapter.replug();
    await clock.advance(1000);
    expect(link.state.status).toBe('on');
  });
});

describe('a stream that fails with its plug in', () => {
  it('is tried for 15 seconds when the port does not open again', async () => {
    const { clock, port, states } = await on();
    port.device.error('lost');
    port.device.busy = true;
    await clock.advance(14_500);
    expect(way(states)).toBe('away > opening');
    await clock.advance(1500);
    expect(way(states)).toBe('away > opening > off (busy)');
  });

  it('is opened more and more rarely when it fails each time, and given up', async () => {
    const { clock, link, port, connect } = linkBench();
    const opened: number[] = [];
    const begin = clock.now();
    port.device.onopenchange = (options) => {
      if (!options) return;
      opened.push(clock.now() - begin);
      port.device.error('lost');
    };
    await connect();
    await clock.advance(60_000);
    expect(opened).toEqual([0, 200, 1200, 3200, 7200, 15_200]);
    expect(link.state).toMatchObject({ status: 'off', error: { code: 'lost' } });
  });

  it('is opened as quickly as the first time when it was unplugged meanwhile', async () => {
    const { clock, link, port, adapter } = await on();
    for (let i = 0; i < 3; i++) {
      port.device.error('lost');
      await clock.advance(2500);
    }
    adapter.unplug();
    adapter.replug();
    await clock.advance(100);
    port.device.error('lost');
    await clock.advance(500);
    expect(link.state.status).toBe('on');
  });

  it('is never given up when it fails now and then', async () => {
    const { clock, link, port } = await on();
    for (let i = 0; i < 20; i++) {
      port.device.error('lost');
      await clock.advance(11_000);
      expect(link.state.status).toBe('on');
    }
  });
});

it.each(['framing', 'parity', 'break', 'overrun', 'system'] as const)('a %s error ends no connection', async (kind) => {
  const { clock, link, port, states } = await on();
  port.device.error(kind);
  await clock.advance(100);
  await clock.run(link.recheck());
  expect(states).toEqual([]);
  expect(connectionOf(link).client.identity).toEqual(B536);
});
