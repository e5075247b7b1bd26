import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { formatInterval, formatTime, type Parsed, parseInterval, parseSteps, parseTime } from '../../src/app/units.js';

const times: [text: string, parsed: number | string][] = [
  ['0', 0],
  ['0.00', 0],
  ['12', 1200],
  ['12.5', 1250],
  ['12,5', 1250],
  ['12.05', 1205],
  ['12.050', 1205],
  ['12.', 1200],
  ['.5', 50],
  ['.07', 7],
  ['0.07', 7],
  ['0.29', 29],
  ['1.15', 115],
  ['4.35', 435],
  ['  3  ', 300],
  ['2:05', 12500],
  ['2:5', 12500],
  ['2:05.5', 12550],
  ['2:05,25', 12525],
  ['2.05.5', 12550],
  ['2,05,5', 12550],
  ['10:55.35', 65535],
  ['655.35', 65535],
  ['655.36', 65536],
  ['0:00', 0],
  ['180', 18000],
  ['0012', 1200],
  ['', 'empty'],
  ['   ', 'empty'],
  ['.', 'not-a-time'],
  [',', 'not-a-time'],
  [':', 'not-a-time'],
  ['2:', 'not-a-time'],
  [':30', 'not-a-time'],
  ['2:.5', 'not-a-time'],
  ['2:60', 'not-a-time'],
  ['2:005', 'not-a-time'],
  ['1:2:3', 'not-a-time'],
  ['1.2.3', 'not-a-time'],
  ['1,000.5', 'not-a-time'],
  ['abc', 'not-a-time'],
  ['12s', 'not-a-time'],
  ['1e3', 'not-a-time'],
  ['0x10', 'not-a-time'],
  ['Infinity', 'not-a-time'],
  ['NaN', 'not-a-time'],
  ['-1', 'not-a-time'],
  ['+1', 'not-a-time'],
  ['−1', 'not-a-time'],
  ['1 2', 'not-a-time'],
  ['٣', 'not-a-time'],
  ['１２', 'not-a-time'],
  ['½', 'not-a-time'],
  ['1\u0000', 'not-a-time'],
  ['9999999', 'not-a-time'],
  ['12.001', 'too-fine'],
  ['12.0000000001', 'too-fine'],
];

const steps: [text: string, parsed: number | string][] = [
  ['0', 0],
  ['65', 65],
  [' 65 ', 65],
  ['130', 130],
  ['131', 131],
  ['007', 7],
  ['-1', -1],
  ['', 'empty'],
  [' ', 'empty'],
  ['1.5', 'not-a-whole-number'],
  ['1,0', 'not-a-whole-number'],
  ['1e1', 'not-a-whole-number'],
  ['+1', 'not-a-whole-number'],
  ['--1', 'not-a-whole-number'],
  ['-', 'not-a-whole-number'],
  ['six', 'not-a-whole-number'],
  ['0x41', 'not-a-whole-number'],
  ['٦٥', 'not-a-whole-number'],
  ['9999999', 'not-a-whole-number'],
];

function plain(parsed: Parsed): number | string {
  return 'value' in parsed ? parsed.value : parsed.unreadable;
}

describe('a typed time', () => {
  it.each(times)('%j is %j', (text, expected) => {
    expect(plain(parseTime(text))).toBe(expected);
  });

  it('comes back from its usual form, for every time that a timer can hold', () => {
    for (let time = 0; time <= 65535; time++) {
      const text = formatTime(time);
      if (plain(parseTime(text)) !== time)
        expect.fail(`${time} is shown as ${text}, which is ${plain(parseTime(text))}`);
    }
  });

  it('is the same with a comma as with a point', () => {
    for (let time = 0; time <= 65535; time += 7) {
      expect(plain(parseTime(formatTime(time).replace('.', ',')))).toBe(time);
    }
  });
});

describe('typed steps', () => {
  it.each(steps)('%j is %j', (text, expected) => {
    expect(plain(parseSteps(text))).toBe(expected);
  });
});

describe('typed intervals', () => {
  it.each([
    ['12,5', 1250],
    ['-1.5', -150],
    ['−0:02', -200],
    [' -.5 ', -50],
    ['-0', 0],
    ['', 'empty'],
    ['-', 'not-a-time'],
    ['--1', 'not-a-time'],
    ['- 1', 'not-a-time'],
    ['1-', 'not-a-time'],
    ['-1e3', 'not-a-time'],
    ['-1.001', 'too-fine'],
  ])('%j is %j', (text, expected) => {
    expect(plain(parseInterval(text))).toBe(expected);
  });

  it('come back from their usual form', () => {
    for (let interval = -65535; interval <= 65535; interval += 7) {
      expect(plain(parseInterval(formatInterval(interval)))).toBe(interval);
    }
    expect([formatInterval(-150), formatInterval(0), formatInterval(12500)]).toEqual(['-1.50', '0.00', '2:05']);
  });
});

describe('hostile texts', () => {
  it('are a whole number of units or have a reason, however long they are', () => {
    const pieces = fc.constantFrom('0', '9', '.', ',', ':', '-', ' ', 'e', '٣', '\n');
    const hostile = fc.oneof(fc.string({ unit: 'binary' }), fc.string({ unit: pieces, maxLength: 12 }));
    fc.assert(
      fc.property(hostile, (text) => {
        for (const parsed of [parseTime(text), parseInterval(text), parseSteps(text)]) {
          if ('value' in parsed) expect(Number.isSafeInteger(parsed.value)).toBe(true);
          else expect(parsed.unreadable).toMatch(/^[a-z-]+$/);
        }
      }),
      { numRuns: 2000 },
    );
    // A pattern that looks back and forth would be at it until the test is stopped.
    for (const long of ['9'.repeat(1e6), `1.${'0'.repeat(1e6)}`, `${' '.repeat(1e6)}x`, '1:'.repeat(5e5)]) {
      expect([typeof parseTime(long), typeof parseSteps(long)]).toEqual(['object', 'object']);
    }
  });
});

describe('the usual form of a time', () => {
  it.each([
    [0, '0.00'],
    [7, '0.07'],
    [50, '0.50'],
    [1205, '12.05'],
    [5999, '59.99'],
    [6000, '1:00'],
    [6001, '1:00.01'],
    [18000, '3:00'],
    [18050, '3:00.50'],
    [65535, '10:55.35'],
  ])('of %i is %s', (time, text) => {
    expect(formatTime(time)).toBe(text);
  });
});
