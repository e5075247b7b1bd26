import { runInNewContext } from 'node:vm';
import fc from 'fast-check';
import { describe, expect, expectTypeOf, it } from 'vitest';
import {
  COMMAND_NAMES,
  COMMANDS,
  CodecError,
  decodeReply,
  encodeFrame,
  encodeReply,
  encodeRequest,
  FrameDecoder,
  type Identity,
  type ReplyOf,
} from '../../src/protocol/index.js';

const SIZES = { functions: 10, memories: 4, servos: 3 };
const identity: Identity = { timerClass: 'Q', firmware: '536', functions: 4, memories: 4, servos: 2 };
const loose = (work: (...values: never[]) => unknown) => work as (...values: unknown[]) => unknown;

describe('a caller without types', () => {
  const anything = fc.anything({ maxDepth: 2, withSparseArray: true, withNullPrototype: true, withBigInt: true });
  const message = fc.oneof(
    anything,
    fc.record({ name: fc.oneof(fc.constantFrom(...COMMAND_NAMES, '__proto__', 'toString'), anything) }),
    fc.record({
      name: fc.constantFrom(...COMMAND_NAMES),
      times: anything,
      positions: anything,
      memory: anything,
      function: anything,
      servo: anything,
      position: anything,
      idleThrottle: anything,
      identity: fc.oneof(anything, fc.record({ timerClass: anything, firmware: anything, functions: anything })),
    }),
  );

  it.each([
    ['encodeRequest', loose(encodeRequest)],
    ['encodeReply', loose(encodeReply)],
  ])('%s gives bytes or a CodecError, whatever it is given', (_, encode) => {
    fc.assert(
      fc.property(message, fc.constantFrom({}, { identity }), (given, options) => {
        try {
          expect(new FrameDecoder().push(encode(given, options) as Uint8Array)).toHaveLength(1);
        } catch (error) {
          expect(error).toBeInstanceOf(CodecError);
        }
      }),
      { numRuns: 2000 },
    );
  });

  it.each([
    ['nothing', undefined],
    ['null', null],
    ['a name of nothing', { name: 'toString' }],
    ['a symbol', { name: Symbol('GETSWVER') }],
  ])('is told that %s is not a request', (_, request) => {
    expect(() => loose(encodeRequest)(request)).toThrow(expect.objectContaining({ code: 'unknown-command' }));
  });

  it.each([
    ['null', null, 'wrong-type'],
    ['an object', {}, 'wrong-type'],
    ['a list of no length', { length: -1 }, 'wrong-length'],
    ['a text', 'ab', 'not-an-integer'],
    ['a list with a hole', Array(2), 'not-an-integer'],
    ['what is no text', [Object.create(null)], 'not-an-integer'],
  ])('is told that %s is not data', (_, data, code) => {
    expect(() => loose(encodeFrame)(1, data)).toThrow(expect.objectContaining({ name: 'CodecError', code }));
  });

  it('is told of a hole in a list of values', () => {
    const holed = [1, 2, 3, 4, 5];
    delete holed[1];
    expect(() => encodeRequest({ name: 'SETTIMERS', times: holed }, { identity })).toThrow('times[1]');
    const positions = [[1, 2, 3, 4, 5], holed];
    expect(() => encodeReply({ name: 'GETSERVOPOS', positions }, { identity })).toThrow('positions[1][1]');
  });
});

describe('shared data', () => {
  it('cannot be changed: the table of commands, down to its rows and lists', () => {
    const change = (object: object, name: string): void => {
      expect(Reflect.set(object, name, 0), `${name} can be changed`).toBe(false);
    };
    change(COMMANDS, 'GETTIMERS');
    for (const name of COMMAND_NAMES) {
      for (const field of Object.keys(COMMANDS[name])) change(COMMANDS[name], field);
      expect(
        Object.isFrozen(COMMANDS[name].sends) && Object.isFrozen(COMMANDS[name].answers),
        `the lists of ${name} are frozen`,
      ).toBe(true);
      for (const field of [...COMMANDS[name].sends, ...COMMANDS[name].answers]) change(field, 'encode');
    }
    expect(() => (COMMAND_NAMES as string[]).push('X')).toThrow(TypeError);
  });

  it('is small: the data of a frame does not keep a large chunk in memory', () => {
    const frame = encodeFrame(0x76, [7]);
    const chunk = new Uint8Array(1 << 20).fill(0x55);
    chunk.set(frame, 1000);
    chunk.set(frame, (1 << 20) - frame.length);
    const [first, last] = new FrameDecoder().push(chunk);
    for (const found of [first, last]) {
      expect([...(found?.data ?? [])]).toEqual([7]);
      expect(found?.data.buffer.byteLength).toBeLessThanOrEqual(4096);
    }
  });

  it('is large enough for each frame of a chunk that is longer than the shared memory', () => {
    const sent = Array.from({ length: 400 }, (_, at) =>
      encodeFrame(0x62, [at & 0xff, at >> 8, ...Array(at % 60).fill(at & 0x7f)]),
    );
    const chunk = Uint8Array.from(sent.flatMap((bytes) => [...bytes]));
    const found = new FrameDecoder().push(chunk);
    chunk.fill(0);
    expect(found.map(({ code, data }) => encodeFrame(code, data))).toEqual(sent);
  });
});

describe('what is pushed into a decoder', () => {
  const bytes = encodeFrame(0x6b);

  it.each<[string, unknown]>([
    ['a text', 'k'],
    ['nothing', undefined],
    ['null', null],
    ['an ArrayBuffer', bytes.buffer],
    ['a DataView', new DataView(bytes.buffer)],
    ['words of two bytes', new Uint16Array(9)],
    ['numbers', [...bytes]],
  ])('is refused when it is %s, in which no frame would ever be found', (_, chunk) => {
    expect(() => loose(FrameDecoder.prototype.push).call(new FrameDecoder(), chunk)).toThrow(TypeError);
  });

  it('may be a Buffer of Node, and bytes of another realm', () => {
    expect(new FrameDecoder().push(Buffer.from(bytes))).toHaveLength(1);
    const foreign = runInNewContext('Uint8Array.from(bytes)', { bytes: [...bytes] }) as Uint8Array;
    expect(foreign).not.toBeInstanceOf(Uint8Array);
    expect(new FrameDecoder().push(foreign)).toHaveLength(1);
  });
});

describe('a request without an identity', () => {
  const requests = [
    { name: 'SETSERVO', function: 0, servo: 0, position: 131 },
    { name: 'SETSERVO', function: 126, servo: 0, position: 0 },
    { name: 'SETSERVO', function: 0, servo: 126, position: 0 },
    { name: 'MOVETOFUNC', function: 126 },
    { name: 'SETMEMORY', memory: 255 },
    { name: 'SETLOWRPM', idleThrottle: 256 },
  ] as const;

  it.each(requests)('is refused when no timer can take it: %o', (request) => {
    expect(() => encodeRequest(request)).toThrow(expect.objectContaining({ code: 'out-of-range' }));
  });

  it.each(requests)('is a frame at the edge of that: %o', (request) => {
    const least = (value: unknown): unknown => (typeof value === 'number' && value > 0 ? value - 1 : value);
    const fits = Object.fromEntries(Object.entries(request).map(([name, value]) => [name, least(value)]));
    expect(loose(encodeRequest)(fits)).toBeInstanceOf(Uint8Array);
  });
});

const version = (...other: [at: number, byte: number][]) => {
  const data = Uint8Array.from([0x42, 0x35, 0x33, 0x36, 0x20, 10, 4, 3, 0x20]);
  for (const [at, byte] of other) data[at] = byte;
  return { code: COMMANDS.GETSWVER.reply, data };
};
const read = (frame: { code: number; data: Uint8Array }) => decodeReply(frame, { pending: 'GETSWVER' }).identity;

it('the bytes of an identity that no document explains may be any: the timer can be read all the same', () => {
  for (let byte = 0; byte < 256; byte++) {
    expect(read(version([4, byte], [8, 255 - byte]))).toEqual({ ...identity, timerClass: 'B', ...SIZES });
    const odd = read(version([2, byte]));
    expect(odd.firmware).toMatch(/^(5[0-9A-Za-z. -]6|35[0-9a-f]{2}36)$/);
    expect([...(new FrameDecoder().push(encodeReply({ name: 'GETSWVER', identity: odd }))[0]?.data ?? [])]).toEqual([
      ...version([2, byte]).data,
    ]);
  }
  expect(read(version([1, 5], [2, 3], [3, 6])).firmware).toBe('050306');
  expect(read(version([2, 0x2e])).firmware).toBe('5.6');
});

describe('the type of a reply', () => {
  const frame = { code: COMMANDS.GETLOWRPM.reply, data: Uint8Array.of(12) };

  it('is that of the request that it answers', () => {
    const byName = decodeReply(frame, { pending: 'GETLOWRPM' });
    const byRequest = decodeReply(frame, { pending: { name: 'GETLOWRPM' } });
    expectTypeOf(byName).toEqualTypeOf<ReplyOf<'GETLOWRPM'>>();
    expectTypeOf(byRequest.idleThrottle).toEqualTypeOf<number | null>();
    expect([byName.idleThrottle, byRequest.idleThrottle]).toEqual([12, 12]);
  });

  it('is one flat object', () => {
    expectTypeOf<ReplyOf<'GETLOWRPM'>>().toEqualTypeOf<{
      readonly name: 'GETLOWRPM';
      readonly idleThrottle: number | null;
    }>();
  });
});
