import { describe, expect, it } from 'vitest';
import type { MockSerialPort } from '../../src/mock-serial/index.js';
import { DEFAULT_SETTINGS, type Heard, RATES } from '../../src/serial/index.js';
import { B536 } from '../protocol/vectors.js';
import { connectionOf, linkBench } from './link-bench.js';

const bytes = (text: string): Uint8Array => new TextEncoder().encode(text);

/** A link whose timer sleeps, while something else talks on the port. */
async function hears(talk: (port: MockSerialPort, baudRate: number) => void): Promise<Heard | null> {
  const bench = linkBench({ plug: { timing: true } });
  const { timer, port, link, clock } = bench;
  timer.core.sleep();
  port.device.onopenchange = (opened) => {
    const again = (): void => {
      if (port.device.opened?.baudRate !== opened?.baudRate || !opened) return;
      talk(port, opened.baudRate);
      clock.after(250, again);
    };
    if (opened) clock.after(50, again);
  };
  await bench.connect();
  await clock.advance(3000);
  if (link.state.status !== 'waiting') throw new Error(link.state.status);
  return link.state.heard;
}

describe('bytes that are not from a timer', () => {
  it('are none on a silent line', async () => {
    expect(await hears(() => {})).toBeNull();
  });

  it.each([9600, 115200])('are text at %i baud, and the text is shown', async (rate) => {
    const heard = await hears((port, baudRate) => {
      port.device.write(baudRate === rate ? bytes('$GPGGA,092750,5321.68,N*76\r\n') : [0xf3, 0x81, 0x9c, 0xfe, 0x8d]);
    });
    expect(heard).toMatchObject({ kind: 'text', baudRate: rate });
    expect(new TextDecoder().decode(heard?.sample)).toContain('GPGGA');
    expect(heard?.sample.length).toBeLessThanOrEqual(64);
  });

  it('are noise when they cannot be read at any rate', async () => {
    const heard = await hears((port) => port.device.write([0xf3, 0x81, 0x9c, 0xfe, 0x8d, 0x02]));
    expect(heard).toMatchObject({ kind: 'noise' });
  });

  it('are noise when the port reports only errors of the line', async () => {
    const heard = await hears((port) => {
      for (let i = 0; i < 4; i++) port.device.error('framing');
    });
    expect(heard).toMatchObject({ kind: 'noise' });
  });

  it.each(RATES)('are a slow timer at %i baud when they make its replies, one byte each 300 ms', async (rate) => {
    const { connect, states, clock } = linkBench({ gap: 300, answersAt: rate, plug: { timing: true } });
    await connect();
    await clock.advance(120_000);
    const heard = states.map((state) => (state.status === 'waiting' ? state.heard : null));
    expect(heard.find((each) => each?.kind === 'slow')).toMatchObject({ baudRate: rate });
    expect(heard.at(-1)).toMatchObject({ kind: 'slow' });
  });

  it('do not count when only a few come as a plug is pushed in', async () => {
    let count = 0;
    expect(await hears((port) => void (count++ === 0 && port.device.write([0xff, 0x3c])))).toBeNull();
  });

  it('are an echo when only the question comes back', async () => {
    const { timer, connect, link } = linkBench({ quirks: { echo: true } });
    timer.core.sleep();
    await connect();
    expect(link.state).toMatchObject({ status: 'waiting', heard: { kind: 'echo', sample: new Uint8Array(0) } });
  });

  it('are forgotten when no more came for a while, and when a timer was found', async () => {
    const { timer, port, connect, link, clock } = linkBench();
    timer.core.sleep();
    await connect();
    port.device.write(bytes('Hello, world\r\n'));
    await clock.advance(2000);
    expect(link.state).toMatchObject({ status: 'waiting', heard: { kind: 'text' } });
    await clock.advance(20_000);
    expect(link.state).toMatchObject({ status: 'waiting', heard: null });
    port.device.write(bytes('Hello, world\r\n'));
    timer.core.press();
    await clock.advance(2000);
    expect(connectionOf(link).identity).toEqual(B536);
    timer.core.sleep();
    link.wait();
    expect(link.state).toMatchObject({ status: 'waiting', heard: null });
  });
});

describe('a timer that is slow', () => {
  it.each([900, 2000])('is found when it answers after %i ms, and its delay is learned', async (latency) => {
    const { connect, link, clock, port } = linkBench({ latency });
    await connect(port, { ...DEFAULT_SETTINGS, baudRate: 9600 });
    await clock.advance(10_000);
    const { client, identity } = connectionOf(link);
    expect(identity).toEqual(B536);
    expect(await clock.run(client.readProgram())).toMatchObject({ memory: 0 });
    expect(client.delay).toBeGreaterThan(latency - 50);
    expect(client.damageSeen).toBe(false);
    expect(client.strays).toBe(0);
  });

  it.each([
    [3200, 9600],
    [3600, 9600],
    [5500, 9600],
    [3200, 19200],
    [3600, 115200],
  ])('is found, but not read, when it answers after %i ms at %i baud', async (latency, answersAt) => {
    const { connect, link, clock, timer } = linkBench({ latency, answersAt, plug: { timing: true } });
    await connect();
    await clock.advance(80_000);
    const { client, settings } = connectionOf(link);
    expect(settings.baudRate).toBe(answersAt);
    const program = timer.core.content;
    await expect(clock.run(client.readProgram())).rejects.toMatchObject({
      code: 'too-slow',
      details: { delay: latency },
    });
    expect(client.delay).toBeCloseTo(latency, 2);
    await expect(clock.run(client.readMemories())).rejects.toMatchObject({ code: 'too-slow' });
    expect(timer.core.content).toEqual(program);
  });

  it('is known to be slow when it is asked again over the same link', async () => {
    const { connect, link, clock } = linkBench({ latency: 900 });
    await connect();
    await clock.run(connectionOf(link).client.readProgram());
    link.wait();
    await clock.advance(5000);
    expect(connectionOf(link).client.margin).toBeLessThan(1400);
  });
});
