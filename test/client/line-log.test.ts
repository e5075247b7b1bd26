import { Duplex } from 'node:stream';
import { describe, expect, it } from 'vitest';
import { type BytePort, type LineEntry, TimerClient } from '../../src/client/index.js';
import { VirtualClock } from '../../src/line/index.js';
import { encodeFrame, encodeRequest } from '../../src/protocol/index.js';
import { VirtualTimer } from '../../src/simulator/index.js';
import { type Crowd, crowd } from './crowd.js';

/** A client in whose beam something else can talk. */
async function crowded(): Promise<{ port: Crowd; client: TimerClient; line: LineEntry[]; clock: VirtualClock }> {
  const clock = new VirtualClock();
  const port = crowd(new VirtualTimer({ clock }));
  const line: LineEntry[] = [];
  const client = new TimerClient(port, { clock, onLine: (entry) => line.push(entry) });
  await clock.run(client.identify());
  return { port, client, line, clock };
}

const request = { name: 'SETSERVO', servo: 0, function: 2, position: 41 } as const;

it.each<[string, Uint8Array, boolean]>([
  ['the same frame: its echo', encodeRequest(request), true],
  ['one of the same letter with another value', encodeRequest({ ...request, position: 42 }), false],
  ['one of the same letter that is shorter', encodeFrame(0x63, [2, 0]), false],
  ['one of the same letter that is longer', encodeFrame(0x63, [2, 0, 41, 0]), false],
  ['one of another letter with the same values', encodeFrame(0x67, [2, 0, 41]), false],
])('what comes after a request: %s', async (_, bytes, isEcho) => {
  const { port, client, clock } = await crowded();
  port.stray = (_index, code, moment) => (code === 0x63 && moment === 'before' ? bytes : undefined);
  await clock.run(client.request(request));
  expect([client.quirksFound.has('echo'), client.strays]).toEqual(isEcho ? [true, 0] : [false, 1]);
  expect(client.damageSeen).toBe(false);
});

describe('the line as it is reported', () => {
  it('has what went out, what came, and what belongs to no frame, with the reason and the time', async () => {
    const { port, client, line, clock } = await crowded();
    await clock.advance(250);
    line.length = 0;
    port.say(Uint8Array.of(1, 2, 3));
    await clock.run(client.send(0x6d));
    const rest = { frame: null, rejected: null, error: null };
    expect(line).toEqual([
      { ...rest, time: 250, direction: 'in', bytes: Uint8Array.of(1, 2, 3), rejected: 'noise' },
      {
        ...rest,
        time: 250,
        direction: 'out',
        bytes: encodeFrame(0x6d),
        frame: { code: 0x6d, data: new Uint8Array() },
      },
      { ...rest, time: 250, direction: 'in', bytes: encodeFrame(0x6e), frame: { code: 0x6e, data: new Uint8Array() } },
    ]);
  });

  it('has each frame with its own data and no more', async () => {
    const { client, line, clock } = await crowded();
    await clock.run(client.setPosition({ servo: 1, slot: 4 }, 70));
    const sent = line.find(({ frame }) => frame?.code === 0x63);
    expect(sent?.frame?.data).toEqual(Uint8Array.of(4, 1, 70));
  });
});

describe('a port whose streams are missing', () => {
  it.each(['readable', 'writable'] as const)('is lost when it has no %s', async (side) => {
    const clock = new VirtualClock();
    const { readable, writable } = new VirtualTimer({ clock });
    const lost: string[] = [];
    const port: BytePort = side === 'readable' ? { readable: null, writable } : { readable, writable: null };
    const client = new TimerClient(port, { clock, onLost: ({ code }) => lost.push(code) });
    const refused = { code: 'port-lost', message: expect.stringContaining('not open') };
    await expect(clock.run(client.identify())).rejects.toMatchObject(refused);
    expect(lost).toEqual(['port-lost']);
    await expect(clock.run(client.identify()), 'the port stays lost').rejects.toMatchObject({ code: 'port-lost' });
    expect(lost).toHaveLength(1);
  });

  it.each<[string, unknown, string]>([
    ['null', null, 'readable and a writable'],
    ['nothing', undefined, 'readable and a writable'],
    ['a path', '/dev/ttyUSB0', 'readable and a writable'],
    ['a port of the package serialport', new Duplex(), 'Duplex.toWeb'],
  ])('is refused when it is %s', (_, port, hint) => {
    expect(() => new TimerClient(port as BytePort)).toThrow(TypeError);
    expect(() => new TimerClient(port as BytePort)).toThrow(hint);
  });

  it('is lost when it refuses to be written to, with the cause', async () => {
    const clock = new VirtualClock();
    const { readable } = new VirtualTimer({ clock });
    const cause = new Error('gone');
    const writable = new WritableStream<Uint8Array>({
      write: () => {
        throw cause;
      },
    });
    const client = new TimerClient({ readable, writable }, { clock });
    await expect(clock.run(client.identify())).rejects.toMatchObject({ code: 'port-lost', cause });
  });
});
