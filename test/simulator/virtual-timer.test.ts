import { describe, expect, it } from 'vitest';
import { VirtualClock } from '../../src/line/index.js';
import { encodeRequest, type Request } from '../../src/protocol/index.js';
import { TimerCore, VirtualTimer, type VirtualTimerOptions } from '../../src/simulator/index.js';
import { B536, CAPTURE, CAPTURED_POSITIONS } from '../protocol/vectors.js';
import { concat, fromHex, toHex } from '../tools/bytes.js';

/** A virtual timer with its line, driven byte by byte with nothing of the client in between. */
function timerOnLine(options: VirtualTimerOptions = {}) {
  const clock = new VirtualClock();
  const timer = new VirtualTimer({ clock, ...options });
  const received: string[] = [];
  const reader = timer.readable.getReader();
  void (async () => {
    for (;;) {
      const { value, done } = await reader.read();
      if (done) return;
      received.push(toHex(value));
    }
  })().catch((error: Error) => received.push(error.message));
  const writer = timer.writable.getWriter();
  const send = async (bytes: Uint8Array, ms = 1000): Promise<string[]> => {
    received.length = 0;
    await writer.write(bytes);
    await clock.advance(ms);
    return [...received];
  };
  const ask = (request: Request): Promise<string[]> => send(encodeRequest(request));
  return { clock, timer, send, ask, received };
}

describe('the virtual timer', () => {
  it('answers the version request of the source, with its four zeros, as a timer of the source does', async () => {
    const { send } = timerOnLine();
    expect(await send(fromHex('00 00 00 00 03 6B 6B 45'))).toEqual([
      '00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45',
    ]);
  });

  it('holds the captured positions at the beginning, and sends them as the real timer did', async () => {
    const { ask, timer } = timerOnLine();
    expect(timer.core.content.positions).toEqual([CAPTURED_POSITIONS, CAPTURED_POSITIONS, CAPTURED_POSITIONS]);
    expect(await ask({ name: 'GETSERVOPOS' })).toEqual([CAPTURE]);
  });

  it('holds times that rise, in every class and layout', () => {
    for (const timerClass of ['B', 'Q', 'E']) {
      for (const functions of [1, 2, 10, 125]) {
        const { core } = new VirtualTimer({ identity: { timerClass, functions, servos: 1 } });
        const times = core.content.times.slice(1);
        expect(times).toEqual([...new Set(times)].sort((a, b) => a - b));
      }
    }
  });

  it('keeps each memory to itself', async () => {
    const { ask, timer } = timerOnLine();
    await ask({ name: 'SETSERVO', function: 0, servo: 1, position: 99 });
    await ask({ name: 'SETMEMORY', memory: 1 });
    await ask({ name: 'SETTIMERS', times: [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10] });
    expect(timer.core.memories[0]?.positions[1]?.[0]).toBe(99);
    expect(timer.core.memories[1]?.positions[1]?.[0]).toBe(15);
    expect(timer.core.memories[1]?.times).toEqual([0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10]);
    expect(timer.core.memories[0]?.times[1]).toBe(50);
    expect(await ask({ name: 'GETMEMORY' })).toEqual(['00 00 00 00 00 04 72 01 73 45']);
  });

  it.each([
    ['never', [35, 35, 35]],
    ['there', [40, 35, 35]],
    ['always', [40, 50, 35]],
  ] as const)('moves servos when told, and when a position is stored: %s', async (setMoves, servos) => {
    const { timer, ask } = timerOnLine({ quirks: { setMoves } });
    expect(timer.core.servos, 'they stand at DT when it gets power').toEqual([115, 115, 115]);
    await ask({ name: 'MOVETOFUNC', function: 2 });
    expect(timer.core.servos).toEqual([35, 35, 35]);
    await ask({ name: 'SETSERVO', servo: 0, function: 2, position: 40 });
    await ask({ name: 'SETSERVO', servo: 1, function: 5, position: 50 });
    expect(timer.core.servos).toEqual(servos);
    expect([timer.core.content.positions[0]?.[2], timer.core.content.positions[1]?.[5]]).toEqual([40, 50]);
  });

  it('does not answer damage, values out of range, or bytes that are not a request', async () => {
    const { send, timer } = timerOnLine();
    for (const hex of [
      '00 00 00 00 00 03 6b 6c 45',
      '00 00 00 00 00 06 63 00 00 83 e6 45',
      '00 00 00 00 00 04 73 04 77 45',
      '00 00 00 00 00 03 6e 6e 45',
      '00 00 00 00 00 04 6b 00 6b 45',
    ]) {
      expect(await send(fromHex(hex))).toEqual([]);
    }
    expect(timer.core.answered).toEqual([]);
  });

  it('answers again after a damaged length as soon as the line falls silent', async () => {
    const { send, ask } = timerOnLine();
    expect(await send(fromHex('00 00 00 00 00 ff 6b 6b 45'))).toEqual([]);
    expect(await ask({ name: 'GETSWVER' })).toHaveLength(1);
    // The silence is counted from the last piece of a request.
    const request = encodeRequest({ name: 'GETSWVER' });
    expect(await send(request.subarray(0, 6), 80)).toEqual([]);
    expect(await send(request.subarray(6, 7), 80)).toEqual([]);
    expect(await send(request.subarray(7))).toHaveLength(1);
  });

  it('falls asleep after a while, loses nothing, and wakes when its switch is pressed', async () => {
    const { clock, ask, timer } = timerOnLine({ sleepAfter: 60_000 });
    await ask({ name: 'SETMEMORY', memory: 2 });
    await clock.advance(50_000);
    expect(await ask({ name: 'GETMEMORY' })).toHaveLength(1);
    await clock.advance(61_000);
    expect(await ask({ name: 'GETMEMORY' })).toEqual([]);
    timer.core.press();
    expect(await ask({ name: 'GETMEMORY' })).toEqual(['00 00 00 00 00 04 72 02 74 45']);
  });

  it('locks the motor of class Q until it is unlocked', async () => {
    const q = timerOnLine({ identity: { timerClass: 'Q' } });
    expect(q.timer.core.motorLocked).toBe(true);
    await q.ask({ name: 'UNLOCK' });
    expect(q.timer.core.motorLocked).toBe(false);
    expect(timerOnLine().timer.core.motorLocked).toBe(false);
  });

  it('takes the time of its line in both directions, and its latency once', async () => {
    const { send } = timerOnLine({ baudRate: 9600, latency: 40 });
    const request = encodeRequest({ name: 'GETSWVER' });
    const ms = ((request.length + 18) * 10_000) / 9600 + 40;
    expect(await send(request, ms - 1)).toEqual([]);
    const again = timerOnLine({ baudRate: 9600, latency: 40 });
    expect(await again.send(request, ms + 1)).toHaveLength(1);
  });

  it('fails reading and writing once its line is cut', async () => {
    const { timer, send, received, clock } = timerOnLine();
    timer.cut();
    await clock.advance(0);
    expect(received).toEqual(['The line to the timer is cut.']);
    await expect(send(Uint8Array.of(1))).rejects.toThrow('cut');
  });

  it('sends nothing to a reader that has gone before the answer is complete', async () => {
    const clock = new VirtualClock();
    const { readable, writable } = new VirtualTimer({ clock, latency: 40 });
    await writable.getWriter().write(encodeRequest({ name: 'GETSWVER' }));
    await readable.cancel();
    await clock.advance(1000);
  });

  it('refuses an identity that no version reply can describe', () => {
    expect(() => new VirtualTimer({ identity: { servos: 0 } })).toThrowError(
      expect.objectContaining({ code: 'bad-identity' }),
    );
  });

  it('answers several requests in one chunk in order', async () => {
    const { send } = timerOnLine();
    const both = concat(encodeRequest({ name: 'GETMEMORY' }), encodeRequest({ name: 'GETSWVER' }));
    expect((await send(both)).join(' ')).toMatch(/^00 00 00 00 00 04 72 .* 6c 42 /);
  });

  it('keeps the latest thousand of the requests that it has answered', () => {
    const core = new TimerCore({ identity: B536, quirks: {}, clock: new VirtualClock() });
    for (let request = 0; request < 1001; request++) core.answer({ code: 0x71, data: new Uint8Array(0) });
    core.answer({ code: 0x6b, data: new Uint8Array(0) });
    expect(core.answered.length).toBe(1000);
    expect(core.answered.at(-1)).toEqual({ name: 'GETSWVER' });
  });
});

describe('an option that is no number', () => {
  it('is refused at once', () => {
    for (const timeStep of [0, -3, 1.5, Number.NaN])
      expect(() => new VirtualTimer({ quirks: { timeStep } })).toThrow('timeStep must be a whole number above 0');
    for (const sleepAfter of [-1, Number.NaN])
      expect(() => new VirtualTimer({ sleepAfter })).toThrow('sleepAfter must be 0 or more');
    for (const options of [{ latency: Number.NaN }, { baudRate: Number.NaN }])
      expect(() => new VirtualTimer(options)).toThrow(RangeError);
  });
});
