import { describe, expect, it } from 'vitest';
import { ByteLine, type ByteLineOptions, VirtualClock, wireTime } from '../../src/line/index.js';
import { toHex } from '../tools/bytes.js';

function lineOf(options: Omit<ByteLineOptions, 'clock'>): { clock: VirtualClock; line: ByteLine; arrived: string[] } {
  const clock = new VirtualClock();
  const arrived: string[] = [];
  const line = new ByteLine((bytes) => arrived.push(`${clock.now()}: ${toHex(bytes)}`), { clock, ...options });
  return { clock, line, arrived };
}

describe('a byte line', () => {
  it('takes ten bits a byte', () => {
    expect(wireTime(960, 9600)).toBe(1000);
    expect(wireTime(960, 0)).toBe(0);
  });

  it('delivers when the last byte has passed, and not before send has returned', async () => {
    const { clock, line, arrived } = lineOf({ baudRate: 10_000, latency: 5 });
    expect(line.send(Uint8Array.of(1, 2, 3))).toBe(3);
    expect(line.send(Uint8Array.of(4))).toBe(4);
    expect(arrived).toEqual([]);
    await clock.advance(100);
    expect(arrived).toEqual(['8: 01 02 03', '9: 04']);
  });

  it('does not call back at once on a line without a speed', async () => {
    const { clock, line, arrived } = lineOf({});
    line.send(Uint8Array.of(1));
    expect(arrived).toEqual([]);
    await clock.advance(0);
    expect(arrived).toEqual(['0: 01']);
  });

  it('cuts into pieces that go on across sends, each at its own time', async () => {
    const { clock, line, arrived } = lineOf({ baudRate: 10_000, chunks: [1, 3] });
    line.send(Uint8Array.of(1, 2));
    line.send(Uint8Array.of(3, 4, 5));
    await clock.advance(100);
    expect(arrived).toEqual(['1: 01', '2: 02', '4: 03 04', '5: 05']);
  });

  it('loses, flips and doubles bytes as told, counted from the first', async () => {
    const { clock, line, arrived } = lineOf({
      fault: (byte, index) => [[byte], [], [byte ^ 0xff], [byte, byte]][index] ?? [byte],
    });
    line.send(Uint8Array.of(1, 2));
    line.send(Uint8Array.of(3, 4, 5));
    await clock.advance(0);
    expect(arrived).toEqual(['0: 01', '0: fc 04 04 05']);
  });

  it('delivers nothing more once it is cut', async () => {
    const { clock, line, arrived } = lineOf({ baudRate: 10_000, chunks: [1] });
    line.send(Uint8Array.of(1, 2, 3));
    await clock.advance(2);
    line.cut();
    line.send(Uint8Array.of(4));
    await clock.advance(100);
    expect(arrived).toEqual(['1: 01', '2: 02']);
  });

  it('forgets the bytes on their way when cleared, and is free again at once', async () => {
    const { clock, line, arrived } = lineOf({ baudRate: 10_000 });
    line.send(new Uint8Array(100));
    line.clear();
    line.send(Uint8Array.of(7));
    await clock.advance(100);
    expect(arrived).toEqual(['1: 07']);
  });

  it('keeps the order also on a clock that calls back in the wrong order for times that lie close together', () => {
    // As setTimeout does, which knows no part of a millisecond.
    const kept: (() => void)[] = [];
    const after = (_: number, callback: () => void): (() => void) => {
      kept.unshift(callback);
      return () => {};
    };
    const arrived: string[] = [];
    const line = new ByteLine((bytes) => arrived.push(toHex(bytes)), {
      clock: { now: () => 0, after },
      baudRate: 9600,
      chunks: [1],
    });
    line.send(Uint8Array.of(1, 2, 3));
    for (const callback of kept) callback();
    expect(arrived).toEqual(['01', '02', '03']);
  });

  it.each([Uint8Array.of(1, 2), Buffer.of(1, 2)])('hands over its own copy of %o', async (bytes) => {
    const clock = new VirtualClock();
    const arrived: Uint8Array[] = [];
    const line = new ByteLine((piece) => arrived.push(piece), { clock });
    line.send(bytes);
    bytes.fill(9);
    await clock.advance(0);
    expect(arrived).toEqual([Uint8Array.of(1, 2)]);
  });
});

describe('a line that cannot be', () => {
  const wrong = [Number.NaN, -1, '5'] as number[];
  it.each(wrong)('is refused at once: %s', (value) => {
    for (const options of [{ baudRate: value }, { latency: value }, { chunks: [1, value] }])
      expect(() => lineOf(options), Object.keys(options)[0]).toThrow(RangeError);
  });
});
