import { getEventListeners } from 'node:events';
import { describe, expect, it } from 'vitest';
import { TimerError } from '../../src/client/index.js';
import { LearnedTiming } from '../../src/client/line-timing.js';
import type { BytePort } from '../../src/client/port.js';
import { Quirks } from '../../src/client/quirks.js';
import { Wire } from '../../src/client/wire.js';
import { VirtualClock } from '../../src/line/index.js';
import { encodeFrame, encodeReply, encodeRequest, type Identity, type Request } from '../../src/protocol/index.js';
import { concat, fromHex } from '../tools/bytes.js';

const identity: Identity = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 };
const ASKED: Request = { name: 'GETMEMORY' };
const ANSWER = encodeReply({ name: 'GETMEMORY', memory: 2 }, { identity });
const NOISE = fromHex('01 02');
const STRAY = encodeReply({ name: 'GETSWVER', identity });
const BAD = encodeFrame(0x72, [1, 2, 3]);
/** A header that asks for more than comes. */
const FALSE_HEADER = fromHex('00 00 00 00 30');

/** A wire of which a test is the other end. One byte takes one millisecond, and a reply may take 600 more. */
function setUp(write: () => Promise<void> = async () => {}) {
  const clock = new VirtualClock(1000);
  const timing = new LearnedTiming({ baudRate: 10_000, margin: 600 });
  const lost: string[] = [];
  let controller: ReadableStreamDefaultController<Uint8Array> | undefined;
  const port = {
    readable: new ReadableStream<Uint8Array>({
      start: (own) => {
        controller = own;
      },
    }),
    writable: new WritableStream<Uint8Array>({ write }),
  };
  const wire = new Wire(port, new Quirks({}), {
    timing,
    clock,
    onLine: undefined,
    onLost: ({ code }) => lost.push(code),
  });
  const ask = (request = ASKED) => wire.ask({ request, identity, misprints: 'yes' });
  return {
    wire,
    clock,
    timing,
    port,
    lost,
    ask,
    say: (bytes: Uint8Array) => controller?.enqueue(bytes),
    end: () => controller?.close(),
    /** Says something every so many milliseconds, from now on. */
    repeat(bytes: Uint8Array, every: number) {
      const say = (): void => {
        controller?.enqueue(bytes);
        clock.after(every, say);
      };
      clock.after(0, say);
    },
    /** What a promise gives, and after how many milliseconds. */
    async timed<T>(promise: Promise<T>): Promise<[T, number]> {
      const begin = clock.now();
      const value = await clock.run(promise);
      return [value, clock.now() - begin];
    },
  };
}

describe('how long the client waits for an answer', () => {
  // 9 bytes of request, 10 of reply.
  const UNTIL = 9 + 10 + 600;

  it('the bytes of both and the margin; by hand the same, and the longest where the reply is not known', async () => {
    const { wire, ask, timed } = setUp();
    expect(await timed(ask())).toEqual([{ kind: 'silent' }, UNTIL]);
    expect(await timed(wire.send(0x71, [], identity))).toEqual([{ kind: 'silent' }, UNTIL]);
    expect(await timed(wire.send(0x72, [], identity))).toEqual([{ kind: 'silent' }, 10 - 1 + 261 + 600]);
    expect(await timed(wire.send(0x81, [1], identity))).toEqual([{ kind: 'silent' }, 10 + 261 + 600]);
  });

  it('until a silence of 60 ms after the last byte, if bytes come at the end', async () => {
    const { ask, timed, say, clock } = setUp();
    clock.after(UNTIL - 10, () => say(Uint8Array.of(0)));
    clock.after(UNTIL + 40, () => say(Uint8Array.of(0)));
    expect(await timed(ask())).toEqual([{ kind: 'silent' }, UNTIL + 100]);
    clock.after(UNTIL - 60, () => say(Uint8Array.of(0)));
    expect(await timed(ask())).toEqual([{ kind: 'silent' }, UNTIL]);
  });

  it('at most the longest frame and a silence more', async () => {
    const { ask, timed, repeat } = setUp();
    repeat(Uint8Array.of(0), 40);
    expect(await timed(ask())).toEqual([{ kind: 'silent' }, UNTIL + 261 + 60]);
  });

  it('longer as soon as the timer turns out to be slower', async () => {
    const { ask, timed, timing, clock } = setUp();
    clock.after(300, () => timing.learn(1000));
    expect(await timed(ask())).toEqual([{ kind: 'silent' }, 9 + 10 + 1500]);
  });

  it('the same when the port does not take the request, nor the one after it', async () => {
    const { ask, timed, port, wire } = setUp(() => new Promise(() => {}));
    expect(await timed(ask())).toEqual([{ kind: 'silent' }, UNTIL]);
    expect(await timed(ask())).toEqual([{ kind: 'silent' }, UNTIL]);
    expect(port.writable.locked).toBe(true);
    void wire.close();
    expect(port.writable.locked).toBe(false);
  });
});

describe('what came after a request', () => {
  it.each<[string, Uint8Array[], string, number, number]>([
    ['nothing', [], 'silent', 0, 0],
    ['its echo', [encodeRequest(ASKED)], 'silent', 0, 0],
    ['the request of another', [encodeFrame(0x61)], 'silent', 0, 1],
    ['a frame of another command', [STRAY], 'stray', 0, 1],
    ['a frame of no command', [encodeFrame(0x81)], 'stray', 0, 1],
    ['noise', [NOISE], 'damaged', 1, 0],
    ['an impossible reply', [BAD], 'bad', 1, 0],
    ['noise after a stray frame', [STRAY, NOISE], 'damaged', 1, 1],
    ['a stray frame after noise', [NOISE, STRAY], 'damaged', 1, 1],
    ['an impossible reply after noise', [NOISE, BAD], 'bad', 2, 0],
    ['noise after an impossible reply', [BAD, NOISE], 'bad', 2, 0],
    ['a stray frame after an impossible reply', [BAD, STRAY], 'bad', 1, 1],
    ['the reply after an impossible one', [BAD, ANSWER], 'answer', 1, 0],
    ['a stray frame before the reply', [STRAY, ANSWER], 'answer', 0, 1],
    ['the reply twice', [ANSWER, ANSWER], 'answer', 0, 1],
    ['a frame hidden behind a false header', [concat(FALSE_HEADER, STRAY)], 'damaged', 1, 1],
    ['the reply hidden behind a false header', [concat(FALSE_HEADER, ANSWER)], 'answer', 1, 0],
  ])('%s', async (_, said, kind, damage, strays) => {
    const { wire, ask, say, clock } = setUp();
    const asked = ask();
    for (const bytes of said) say(bytes);
    expect(await clock.run(asked)).toMatchObject({ kind });
    await clock.run(wire.pause(1, undefined));
    expect({ damage: wire.damage, strays: wire.strays }).toEqual({ damage, strays });
  });

  it('by hand: only the next letter is the answer', async () => {
    const { wire, say, clock } = setUp();
    const asked = wire.send(0x71, [], identity);
    say(STRAY);
    expect(await clock.run(asked)).toEqual({ kind: 'stray' });
    const again = wire.send(0x71, [], identity);
    say(ANSWER);
    expect(await clock.run(again)).toEqual({ kind: 'answer', answer: { code: 0x72, data: Uint8Array.of(2) } });
  });

  it('a letter in place of the checksum is damage, except for the idle throttle', async () => {
    const bare = encodeFrame(0x76, [30], { bareChecksum: true });
    const { ask, say, clock } = setUp();
    const asked = ask();
    say(bare);
    expect(await clock.run(asked)).toMatchObject({ kind: 'damaged' });
    const throttle = ask({ name: 'GETLOWRPM' });
    say(bare);
    expect(await clock.run(throttle)).toMatchObject({ kind: 'answer', answer: { idleThrottle: 30 } });
  });
});

describe('a silence', () => {
  it('comes 60 ms after the last byte, at once on a line that has been quiet, or when asked to stop', async () => {
    const { wire, ask, say, timed, clock } = setUp();
    expect((await timed(wire.silence(undefined)))[1]).toBe(0);
    const asked = ask();
    say(ANSWER);
    await clock.run(asked);
    await clock.advance(20);
    expect((await timed(wire.silence(AbortSignal.abort())))[1]).toBe(0);
    expect((await timed(wire.silence(undefined)))[1]).toBe(40);
    expect((await timed(wire.silence(undefined)))[1]).toBe(0);
  });

  it('is given up after a second', async () => {
    const { wire, ask, say, timed, repeat, clock } = setUp();
    const asked = ask();
    say(ANSWER);
    await clock.run(asked);
    repeat(Uint8Array.of(0), 40);
    expect((await timed(wire.silence(undefined)))[1]).toBe(1000);
  });

  it('delivers what an unfinished frame has hidden, and does not count as a slow timer', async () => {
    for (const isHidden of [true, false]) {
      const { wire, ask, say, clock, timing } = setUp();
      await clock.run(ask());
      await clock.advance(100);
      say(isHidden ? concat(FALSE_HEADER, ANSWER) : ANSWER);
      await clock.run(wire.pause(1, undefined));
      await clock.run(wire.silence(undefined));
      expect([wire.strays, timing.delay]).toEqual([0, isHidden ? null : 700]);
    }
  });
});

it('the end of a wait delivers what an unfinished frame has hidden, and does not count as a slow timer', async () => {
  const { wire, ask, say, clock, timing } = setUp();
  await clock.run(ask());
  const asked = ask({ name: 'GETLOWRPM' });
  say(concat(FALSE_HEADER, ANSWER));
  expect(await clock.run(asked)).toMatchObject({ kind: 'damaged' });
  expect([wire.strays, timing.delay]).toEqual([0, null]);
});

describe('a pause', () => {
  it('lasts as long as asked for, whatever comes', async () => {
    const { wire, ask, say, timed, clock } = setUp();
    await clock.run(ask());
    clock.after(50, () => say(STRAY));
    expect(await timed(wire.pause(100, new AbortController().signal))).toEqual([false, 100]);
  });

  it.each([
    ['a stray frame', STRAY],
    ['noise', NOISE],
  ])('is over with %s where it waits for a sign', async (_, bytes) => {
    const { wire, ask, say, timed, clock } = setUp();
    await clock.run(ask());
    clock.after(50, () => say(bytes));
    expect(await timed(wire.pause(100, undefined, true))).toEqual([true, 50]);
  });

  it('ends when asked to stop, and leaves no listener behind', async () => {
    const { wire, timed, clock } = setUp();
    const stop = new AbortController();
    await clock.run(wire.pause(10, stop.signal));
    expect(getEventListeners(stop.signal, 'abort')).toEqual([]);
    clock.after(50, () => stop.abort());
    expect(await timed(wire.pause(100, stop.signal))).toEqual([false, 50]);
    expect(await timed(wire.pause(100, stop.signal, true))).toEqual([false, 0]);
  });

  it('ends with the reason when the port is lost, and there is no pause afterwards', async () => {
    const { wire, ask, clock, end } = setUp();
    await clock.run(ask());
    const begin = clock.now();
    clock.after(50, end);
    const stop = new AbortController();
    await expect(clock.run(wire.pause(100, stop.signal))).rejects.toMatchObject({ code: 'port-lost' });
    await expect(clock.run(wire.pause(100, undefined))).rejects.toMatchObject({ code: 'port-lost' });
    expect([clock.now() - begin, getEventListeners(stop.signal, 'abort')]).toEqual([50, []]);
  });
});

describe('a port that ends', () => {
  it('is reported once, and everyone who waits knows it at once', async () => {
    const { wire, ask, clock, end, lost } = setUp();
    const begin = clock.now();
    const asked = ask();
    end();
    const error = await clock.run(asked).catch((reason: unknown) => reason as TimerError);
    expect(error).toMatchObject({ code: 'port-lost' });
    expect('cause' in (error as TimerError), 'a stream that ends without an error gives no cause').toBe(false);
    await expect(clock.run(ask())).rejects.toMatchObject({ code: 'port-lost' });
    await clock.run(wire.close());
    await expect(clock.run(ask())).rejects.toMatchObject({ code: 'port-lost' });
    expect([lost, clock.now()]).toEqual([['port-lost'], begin]);
  });

  it('is not reported when it was released', async () => {
    const { wire, ask, clock, lost, port } = setUp();
    const asked = ask();
    const refused = expect(clock.run(asked)).rejects.toMatchObject({ code: 'closed' });
    await clock.run(wire.close());
    await refused;
    await expect(clock.run(ask())).rejects.toMatchObject({ code: 'closed' });
    expect([lost, port.readable.locked, port.writable.locked]).toEqual([[], false, false]);
  });

  it('stays open when it was released: another client goes on with the same streams', async () => {
    const { wire, ask, clock, port, say, timing } = setUp();
    await clock.run(ask());
    await clock.run(wire.close());
    const options = { timing, clock, onLine: undefined, onLost: undefined };
    const next = new Wire(port, new Quirks({}), options);
    const asked = next.ask({ request: ASKED, identity });
    say(ANSWER);
    expect(await clock.run(asked)).toMatchObject({ kind: 'answer', answer: { memory: 2 } });
    await clock.run(next.close());
  });

  it('is released by ending its stream where a browser keeps the lock while a read waits', async () => {
    const { port, clock, timing } = setUp();
    let locked = false;
    const { readable } = port;
    const older: BytePort = {
      ...port,
      readable: {
        get locked() {
          return readable.locked;
        },
        getReader() {
          const reader = readable.getReader();
          return {
            async read() {
              locked = true;
              const result = await reader.read();
              locked = false;
              return result;
            },
            cancel: () => reader.cancel(),
            releaseLock() {
              if (locked) throw new TypeError('a read waits');
              reader.releaseLock();
            },
          };
        },
      },
    };
    const wire = new Wire(older, new Quirks({}), { timing, clock, onLine: undefined, onLost: undefined });
    await clock.run(wire.ask({ request: ASKED, identity }));
    await clock.run(wire.close());
    expect([port.readable.locked, port.writable.locked]).toEqual([false, false]);
  });

  it('can be released before it was used', async () => {
    const { wire, clock, lost } = setUp();
    await clock.run(wire.close());
    expect(lost).toEqual([]);
  });

  it('is released although its stream has failed, and the new one is left alone', async () => {
    const { port, clock } = setUp();
    let fail: (error: unknown) => void = () => {};
    const failing: { -readonly [Side in keyof BytePort]: BytePort[Side] } = {
      readable: new ReadableStream<Uint8Array>({
        start: (own) => {
          fail = (error) => own.error(error);
        },
      }),
      writable: port.writable,
    };
    const timing = new LearnedTiming({ baudRate: 10_000, margin: 600 });
    const wire = new Wire(failing, new Quirks({}), { timing, clock, onLine: undefined, onLost: undefined });
    await clock.run(wire.ask({ request: ASKED, identity }));
    failing.readable = port.readable;
    fail(new DOMException('', 'FramingError'));
    await clock.run(wire.close());
    expect([port.readable.locked, wire.lineErrors.size]).toEqual([false, 0]);
  });
});

it('an error of the client has a cause only where there is one', () => {
  expect('cause' in new TimerError('busy', '')).toBe(false);
  expect(new TimerError('busy', '', {}, 7).cause).toBe(7);
});
