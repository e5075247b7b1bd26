import { describe, expect, it } from 'vitest';
import { TimerClient } from '../../src/client/index.js';
import { VirtualClock } from '../../src/line/index.js';
import {
  type CaptureEntry,
  encodeRequest,
  formatCapture,
  parseCapture,
  type Request,
} from '../../src/protocol/index.js';
import { ReplayTimer, VirtualTimer, type VirtualTimerOptions } from '../../src/simulator/index.js';
import { CAPTURE, CAPTURE_PIECES, CAPTURED_POSITIONS } from '../protocol/vectors.js';
import { concat, cut, fromHex, toHex } from '../tools/bytes.js';

const VERSION = '00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45';
const MEMORY_0 = '00 00 00 00 00 04 72 00 72 45';
const MEMORY_3 = '00 00 00 00 00 04 72 03 75 45';
const TIMES = '00 00 00 00 00 19 62 00 00 32 00 64 00 96 00 c8 00 fa 00 2c 01 5e 01 90 01 c2 01 50 46 c6 45';

/**
 * What was read from a timer, with the one reply that is known from a real one as it came: in seven pieces within 100
 * ms.
 */
const recording = [
  '# Sidus capture 1',
  '0.000 > 00 00 00 00 00 03 6b 6b 45',
  `0.060 < ${VERSION}`,
  '1.000 > 00 00 00 00 00 03 71 71 45',
  `1.040 < ${MEMORY_3}`,
  '1.050 > 00 00 00 00 00 03 61 61 45',
  `1.130 < ${TIMES}`,
  '1.200 > 00 00 00 00 00 03 67 67 45',
  ...cut(fromHex(CAPTURE), CAPTURE_PIECES).map((piece, i) => `${(1.24 + 0.014 * i).toFixed(3)} < ${toHex(piece)}`),
].join('\n');

const out = (time: number, request: Request): CaptureEntry => ({
  time,
  direction: 'out',
  bytes: encodeRequest(request),
});
const incoming = (time: number, hex: string): CaptureEntry => ({ time, direction: 'in', bytes: fromHex(hex) });

/** A recorded timer on its line, and what comes from it, each piece with its time. */
function replay(entries: readonly CaptureEntry[]) {
  const clock = new VirtualClock();
  const timer = new ReplayTimer(entries, { clock });
  const received: [time: number, hex: string][] = [];
  void timer.readable.pipeTo(new WritableStream({ write: (bytes) => void received.push([clock.now(), toHex(bytes)]) }));
  const writer = timer.writable.getWriter();
  const send = async (bytes: Uint8Array, ms = 1000) => {
    received.length = 0;
    const begin = clock.now();
    await writer.write(bytes);
    await clock.advance(ms);
    return received.map(([time, hex]) => [time - begin, hex]);
  };
  return { clock, received, send, ask: (request: Request, ms?: number) => send(encodeRequest(request), ms) };
}

/** The same session again: a virtual timer whose line is recorded while a client reads and writes. */
async function recorded(options: VirtualTimerOptions) {
  const clock = new VirtualClock();
  const timer = new VirtualTimer({ clock, baudRate: 9600, latency: 20, ...options });
  const entries: CaptureEntry[] = [];
  const record = (direction: 'in' | 'out') =>
    new TransformStream<Uint8Array, Uint8Array>({
      transform(bytes, controller) {
        entries.push({ time: clock.now(), direction, bytes: bytes.slice() });
        controller.enqueue(bytes);
      },
    });
  const toTimer = record('out');
  void toTimer.readable.pipeTo(timer.writable);
  const port = { readable: timer.readable.pipeThrough(record('in')), writable: toTimer.writable };
  return { clock, port, entries };
}

/** Identifies and reads, changes DT and a position, writes and reads back. */
async function session(client: TimerClient, clock: VirtualClock) {
  const program = await clock.run(client.readProgram());
  const times = program.times.with(-1, 30_000);
  const positions = program.positions.map((row, servo) => (servo === 1 ? row.with(2, 77) : row));
  const report = await clock.run(client.writeProgram({ ...program, times, positions }, { baseline: program }));
  return { program, report, quirks: [...client.quirksFound.keys()] };
}

describe('a recorded timer', () => {
  it('can be read by a client, with the one known reply of a real timer in its seven pieces', async () => {
    const clock = new VirtualClock();
    const client = new TimerClient(new ReplayTimer(parseCapture(recording), { clock }), { clock });
    const program = await clock.run(client.readProgram());
    expect(program.positions).toEqual([CAPTURED_POSITIONS, CAPTURED_POSITIONS, CAPTURED_POSITIONS]);
    expect(program.identity).toMatchObject({ timerClass: 'B', firmware: '536' });
    expect([program.memory, program.times[10]]).toEqual([3, 18000]);
    expect(clock.now(), 'the pauses of the recorded client are left out').toBeLessThan(500);
  });

  it('sends each reply in the pieces and with the delays of the recording', async () => {
    const { ask } = replay(parseCapture(recording));
    const pieces = await ask({ name: 'GETSERVOPOS' });
    expect(pieces.map(([, hex]) => fromHex(hex as string).length)).toEqual(CAPTURE_PIECES);
    expect(pieces.map(([time]) => Math.round(time as number))).toEqual([40, 54, 68, 82, 96, 110, 124]);
    expect(pieces.map(([, hex]) => hex).join(' ')).toBe(CAPTURE);
  });

  it.each<[string, VirtualTimerOptions]>([
    ['a usual timer', {}],
    ['one with other letters and an echo', { quirks: { timersReplyAs66: true, memoryReplyEmpty: true, echo: true } }],
    [
      'class Q on a bad line',
      { identity: { timerClass: 'Q' }, fromTimer: { fault: (b, i) => (i === 30 ? [] : [b]), chunks: [3, 7] } },
    ],
  ])('gives a client the same session again: %s', async (_, options) => {
    const { clock, port, entries } = await recorded(options);
    const first = await session(new TimerClient(port, { clock }), clock);
    expect(first.report.result).toBe('verified');
    const again = new VirtualClock();
    const timer = new ReplayTimer(parseCapture(formatCapture(entries)), { clock: again });
    expect(await session(new TimerClient(timer, { clock: again }), again)).toEqual(first);
  });

  it('answers a repeated request with its recorded replies in turn, then from the beginning', async () => {
    const { ask } = replay([
      out(0, { name: 'GETMEMORY' }),
      incoming(10, MEMORY_0),
      out(100, { name: 'SETMEMORY', memory: 3 }),
      incoming(110, '00 00 00 00 00 03 74 74 45'),
      out(200, { name: 'GETMEMORY' }),
      incoming(230, MEMORY_3),
    ]);
    expect(await ask({ name: 'GETMEMORY' })).toEqual([[10, MEMORY_0]]);
    expect(await ask({ name: 'GETMEMORY' })).toEqual([[30, MEMORY_3]]);
    expect(await ask({ name: 'GETMEMORY' })).toEqual([[10, MEMORY_0]]);
    expect(await ask({ name: 'SETMEMORY', memory: 3 })).toHaveLength(1);
    expect(await ask({ name: 'GETMEMORY' })).toEqual([[30, MEMORY_3]]);
  });

  it('is silent where it was, and to an unknown request', async () => {
    const { ask } = replay([out(0, { name: 'GETMEMORY' }), out(700, { name: 'GETMEMORY' }), incoming(710, MEMORY_3)]);
    expect(await ask({ name: 'GETMEMORY' })).toEqual([]);
    expect(await ask({ name: 'GETMEMORY' })).toEqual([[10, MEMORY_3]]);
    expect(await ask({ name: 'SETMEMORY', memory: 3 })).toEqual([]);
    expect(await ask({ name: 'UNLOCK' })).toEqual([]);
  });

  it('tells a bare checksum from a correct one, and four zeros from none', async () => {
    const bare = '00 00 00 00 04 73 03 73 45';
    const { ask, send } = replay([
      { time: 0, direction: 'out', bytes: fromHex(bare) },
      incoming(5, '00 00 00 00 00 03 74 74 45'),
    ]);
    expect(await ask({ name: 'SETMEMORY', memory: 3 })).toEqual([]);
    expect(await send(fromHex(bare))).toHaveLength(1);
    expect(await send(fromHex(`00 ${bare}`))).toHaveLength(1);
  });

  it('sends by itself what it sent before any request', async () => {
    const { received, clock, ask } = replay([
      incoming(50, 'ff fe'),
      incoming(70, 'fd'),
      ...parseCapture(recording).map((e) => ({ ...e, time: e.time + 100 })),
    ]);
    await clock.advance(100);
    expect(received).toEqual([
      [0, 'ff fe'],
      [20, 'fd'],
    ]);
    expect(await ask({ name: 'GETSWVER' })).toEqual([[60, VERSION]]);
  });

  it('answers several requests in one chunk one after the other', async () => {
    const { send } = replay(parseCapture(recording));
    const both = concat(encodeRequest({ name: 'GETSWVER' }), encodeRequest({ name: 'GETMEMORY' }));
    expect(await send(both)).toEqual([
      [60, VERSION],
      [100, MEMORY_3],
    ]);
  });

  it('is not delayed by noise that was recorded long after a reply', async () => {
    const { ask } = replay([
      out(0, { name: 'GETSWVER' }),
      incoming(60, VERSION),
      incoming(5000, 'ff'),
      out(6000, { name: 'GETMEMORY' }),
      incoming(6040, MEMORY_3),
    ]);
    expect(await ask({ name: 'GETSWVER' }, 100)).toEqual([[60, VERSION]]);
    expect(await ask({ name: 'GETMEMORY' }, 100)).toEqual([[40, MEMORY_3]]);
  });

  it('takes a request in pieces, recorded or sent', async () => {
    const request = encodeRequest({ name: 'SETMEMORY', memory: 3 });
    const { send } = replay([
      { time: 0, direction: 'out', bytes: request.subarray(0, 7) },
      { time: 20, direction: 'out', bytes: request.subarray(7) },
      incoming(30, '00 00 00 00 00 03 74 74 45'),
    ]);
    // The silence that ends a request is counted from its last piece.
    expect(await send(request.subarray(0, 7), 80)).toEqual([]);
    expect(await send(request.subarray(7, 8), 80)).toEqual([]);
    expect(await send(request.subarray(8))).toEqual([[10, '00 00 00 00 00 03 74 74 45']]);
  });

  it('drops an unfinished request, recorded or sent, before the next one', async () => {
    // Its length asks for more than all that comes after it.
    const begun = encodeRequest({ name: 'SETTIMERS', times: Array<number>(11).fill(1) }).subarray(0, 8);
    const { send, ask } = replay([
      { time: 0, direction: 'out', bytes: begun },
      out(500, { name: 'GETMEMORY' }),
      incoming(510, MEMORY_3),
    ]);
    expect(await ask({ name: 'GETMEMORY' })).toEqual([[10, MEMORY_3]]);
    expect(await send(begun)).toEqual([]);
    expect(await ask({ name: 'GETMEMORY' })).toEqual([[10, MEMORY_3]]);
  });
});
