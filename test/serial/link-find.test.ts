import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { DEFAULT_SETTINGS, RATES } from '../../src/serial/index.js';
import { B536 } from '../protocol/vectors.js';
import { canBeOpened } from './bench.js';
import { connectionOf, type LinkBench, type LinkBenchOptions, linkBench, portOf, sent, way } from './link-bench.js';

/** The rates at which a port is opened from now on. */
function ratesOpened({ device }: LinkBench['port']): number[] {
  const rates: number[] = [];
  device.onopenchange = (opened) => opened && rates.push(opened.baudRate);
  return rates;
}

/** A link that waits for a timer that sleeps. */
async function waiting(options: LinkBenchOptions = {}): Promise<LinkBench> {
  const bench = linkBench(options);
  bench.timer.core.sleep();
  await bench.connect();
  expect(bench.link.state.status).toBe('waiting');
  return bench;
}

describe('finding the rate', () => {
  it.each(RATES.map((rate, index) => [rate, index]))('finds a timer that answers only at %i', async (rate, index) => {
    const { connect, link, port, states, clock, line } = linkBench({ answersAt: rate, plug: { timing: true } });
    const rates = ratesOpened(port);
    const begin = clock.now();
    await connect();
    const { settings, identity } = connectionOf(link);
    expect(identity).toEqual(B536);
    expect(settings).toEqual({ ...DEFAULT_SETTINGS, baudRate: rate });
    expect(port.device.opened).toMatchObject({ baudRate: rate });
    expect(rates).toEqual(RATES.slice(0, index + 1));
    expect(clock.now() - begin).toBeLessThan(100 + (index + 1) * 700);
    expect(states.filter(({ status }) => status === 'searching')).toEqual(
      rates.map((baudRate) => ({ status: 'searching', port, baudRate })),
    );
    expect(new Set(sent(line))).toEqual(new Set(['GETSWVER']));
  });

  it('is not delayed by noise at the other rates', async () => {
    const { connect, link, clock } = linkBench({ answersAt: 4800, noise: true, plug: { timing: true } });
    const begin = clock.now();
    await connect();
    expect(connectionOf(link).settings.baudRate).toBe(4800);
    expect(clock.now() - begin).toBeLessThan(6000);
  });

  it('asks the likeliest rate twice, since one question may be lost', async () => {
    const toDevice = (byte: number, index: number) => (index < 9 ? [] : [byte]);
    const { connect, states } = linkBench({ plug: { fault: { toDevice } } });
    await connect();
    expect(states.filter(({ status }) => status === 'searching')).toHaveLength(1);
    expect(way(states)).toBe('opening > searching > on');
  });

  it('uses the remembered rate and settings of the port, also of one that was chosen', async () => {
    const keys: string[] = [];
    const settings = { ...DEFAULT_SETTINGS, stopBits: 2 } as const;
    const remembered = (key: string) => {
      keys.push(key);
      return { settings, knownRate: 38400 };
    };
    const { clock, link, port } = linkBench({ answersAt: 38400, link: { remembered } });
    const rates = ratesOpened(port);
    await clock.run(link.choose());
    expect(connectionOf(link).settings).toEqual({ ...settings, baudRate: 38400 });
    expect(port.device.opened?.stopBits).toBe(2);
    expect([rates, keys]).toEqual([[38400], ['usb:0403:6001']]);
  });

  it('tries only the rate that is set', async () => {
    const { clock, connect, link, port } = linkBench({ answersAt: 9600 });
    const rates = ratesOpened(port);
    await connect(port, { ...DEFAULT_SETTINGS, baudRate: 19200 });
    await clock.advance(30_000);
    expect(link.state).toMatchObject({ status: 'waiting', baudRate: 19200 });
    expect(rates).toEqual([19200]);
  });

  it('tries only one rate over Bluetooth, where the rate has no meaning', async () => {
    const { clock, connect, link, port } = linkBench({ info: { bluetoothServiceClassId: 0x1101 }, answersAt: 1 });
    const rates = ratesOpened(port);
    await connect();
    await clock.advance(30_000);
    expect(link.state.status).toBe('waiting');
    expect(rates).toEqual([9600]);
  });

  it.each([
    ['as the standard has it', () => new TypeError('No such rate.')],
    ['as browsers do', () => new DOMException('Failed to open serial port.', 'NetworkError')],
  ])('skips a rate that the adapter does not know, %s', async (_, refusal) => {
    const { connect, link, port, clock, timer, states } = linkBench({ answersAt: 38400 });
    const open = port.open.bind(port);
    port.open = async (options) => {
      if (options.baudRate === 19200) throw refusal();
      await open(options);
    };
    await connect();
    expect(connectionOf(link).settings.baudRate).toBe(38400);
    link.wait();
    timer.core.sleep();
    await clock.advance(30_000);
    expect(link.state.status).toBe('waiting');
    timer.core.press();
    await clock.advance(3000);
    expect(way(states)).toBe('opening > searching > on > waiting > on');
  });
});

describe('the settings', () => {
  it('are those that the pilot has set', async () => {
    const { connect, port } = linkBench();
    await connect(port, { baudRate: 4800, dataBits: 7, parity: 'even', stopBits: 2, dtr: false, rts: true });
    expect(port.device.opened).toEqual({
      baudRate: 4800,
      dataBits: 7,
      parity: 'even',
      stopBits: 2,
      bufferSize: 16384,
      flowControl: 'none',
    });
    expect(port.device.signals).toMatchObject({ dataTerminalReady: false, requestToSend: true });
  });

  it('leave DTR and RTS as the browser sets them', async () => {
    const { connect, port } = linkBench();
    port.device.failSignals = true;
    await connect();
    expect(port.device.signals).toMatchObject({ dataTerminalReady: true, requestToSend: false });
  });

  const fails: readonly [string, (bench: LinkBench) => void, string][] = [
    ['cannot be set', ({ port }) => void Object.assign(port.device, { failSignals: true }), 'bad-settings'],
    ['is not there', ({ port }) => void Object.assign(port, { setSignals: undefined }), 'bad-settings'],
    [
      'is being set when the plug is pulled',
      ({ port, adapter }) => {
        port.setSignals = async () => {
          adapter.unplug();
          throw new DOMException('Failed to set control signals.', 'NetworkError');
        };
      },
      'unplugged',
    ],
  ];

  it.each(fails)('where DTR %s, end the link, and the port is closed', async (_, fail, code) => {
    const bench = linkBench();
    fail(bench);
    await bench.connect(bench.port, { ...DEFAULT_SETTINGS, dtr: true });
    expect(way(bench.states)).toBe(`opening > off (${code})`);
    expect(bench.port.device.opened).toBeNull();
  });
});

describe('waiting for a timer', () => {
  it('asks about once a second what is there, and nothing else', async () => {
    const { line, clock, link } = await waiting({ plug: { timing: true, latency: 20 } });
    line.length = 0;
    await clock.advance(60_000);
    const asked = sent(line);
    expect(asked.length).toBeGreaterThanOrEqual(59);
    expect(asked.length).toBeLessThanOrEqual(61);
    expect(new Set(asked)).toEqual(new Set(['GETSWVER']));
    expect(link.state.status).toBe('waiting');
  });

  it('finds it within two seconds after it wakes', async () => {
    for (let ms = 0; ms < 4000; ms += 333) {
      const { clock, timer, link } = await waiting();
      await clock.advance(ms);
      timer.core.press();
      await clock.advance(2000);
      expect(link.state.status, `the timer was not found within 2 s after it woke at ${ms} ms`).toBe('on');
    }
  });

  it('finds it within a little more than a minute after it wakes, whatever its rate', async () => {
    const rates = fc.constantFrom(...RATES, 31250);
    await fc.assert(
      fc.asyncProperty(rates, rates, fc.integer({ min: 0, max: 60_000 }), async (answersAt, knownRate, ms) => {
        fc.pre(answersAt !== 31250 || knownRate === 31250);
        const { clock, timer, link, connect } = linkBench({ answersAt, link: { remembered: () => ({ knownRate }) } });
        timer.core.sleep();
        await connect();
        await clock.advance(ms);
        timer.core.press();
        await clock.advance(65_000);
        expect(connectionOf(link).settings.baudRate).toBe(answersAt);
        await clock.run(link.stop());
      }),
      { numRuns: 60 },
    );
  });

  // A home-made bridge whose DTR resets its processor: after each opening it hears nothing for a while.
  it.each([
    [500, 9600],
    [700, 115200],
    [1500, 19200],
    [3000, 9600],
    [3000, 57600],
    [3000, 4800],
  ])(
    'finds an adapter that is deaf for %i ms after each opening, at %i baud, with few openings',
    async (deaf, rate) => {
      const { clock, link, port, adapter } = linkBench({ answersAt: 0 });
      const open = port.open.bind(port);
      let openings = 0;
      port.open = async (options) => {
        await open(options);
        const mine = ++openings;
        adapter.answersAt = 0;
        clock.after(deaf, () => {
          if (mine === openings) adapter.answersAt = rate;
        });
      };
      await clock.run(link.connect(port));
      await clock.advance(80_000);
      expect(connectionOf(link).settings.baudRate).toBe(rate);
      expect(openings).toBeLessThan(30);
    },
  );

  it('stops within one reply time', async () => {
    for (let ms = 0; ms < 1000; ms += 90) {
      const { clock, link, port } = await waiting({ plug: { timing: true } });
      await clock.advance(ms);
      const begin = clock.now();
      await clock.run(link.stop());
      expect(clock.now() - begin).toBeLessThanOrEqual(700);
      expect(await canBeOpened(port)).toBe(true);
    }
  });
});

it('a busy port is tried every second, and each refusal is reported at once', async () => {
  const { clock, link, port, states } = linkBench({ plug: { busy: true } });
  void link.connect(port);
  await clock.advance(5500);
  expect(states).toEqual([0, 1, 2, 3, 4, 5, 6].map((refusals) => ({ status: 'opening', port, refusals })));
  port.device.busy = false;
  await clock.advance(500);
  expect(link.state.status).toBe('on');
});

describe('a connection', () => {
  it('tells everything about the port and the timer', async () => {
    const { connect, link, port } = linkBench();
    await connect();
    expect(portOf(link)).toBe(port);
    const { client, ...rest } = connectionOf(link);
    expect(client.identity).toEqual(B536);
    expect(rest).toEqual({
      identity: B536,
      settings: { ...DEFAULT_SETTINGS, baudRate: 9600 },
      info: { usbVendorId: 0x0403, usbProductId: 0x6001 },
      kind: 'ftdi',
      portKey: 'usb:0403:6001',
    });
  });

  it('begins with what is remembered of such a timer at such a port', async () => {
    const asked: unknown[] = [];
    const assumed = (...of: unknown[]) => {
      asked.push(of);
      return { memoriesFromOne: true };
    };
    const { connect, link } = linkBench({ link: { assumed } });
    await connect();
    expect(asked).toEqual([[B536, 'usb:0403:6001']]);
    expect(connectionOf(link).client.quirksAssumed).toEqual({ memoriesFromOne: true });
  });

  it('needs no browser, only a port', async () => {
    const { connect, link } = linkBench({ link: { serial: undefined } });
    await connect();
    expect(connectionOf(link).identity).toEqual(B536);
    expect(await link.ports()).toEqual([]);
  });
});
