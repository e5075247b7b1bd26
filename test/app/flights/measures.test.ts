import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Measure, measureText, RANGES, readMeasure, steppedMeasure } from '../../../src/app/flights/measures.js';

describe('a number of a flight', () => {
  it.each<[Measure, string, number | null | string]>([
    ['wind', '', null],
    ['wind', '  ', null],
    ['wind', '3', 3],
    ['wind', '3,5', 3.5],
    ['wind', ' 3.5 m/s ', 3.5],
    ['wind', '.5', 0.5],
    ['wind', '50', 50],
    ['wind', '50.1', 'out-of-range'],
    ['wind', '-1', 'out-of-range'],
    ['wind', '1,000.5', 'not-a-number'],
    ['wind', '3e5', 'not-a-number'],
    ['wind', 'calm', 'not-a-number'],
    ['wind', ',', 'not-a-number'],
    ['wind', '-', 'not-a-number'],
    ['temperature', '-2,5', -2.5],
    ['temperature', '−3', -3],
    ['temperature', '+21', 21],
    ['temperature', '12 °C', 12],
    ['temperature', '12°', 12],
    ['temperature', '-0', 0],
    ['temperature', '61', 'out-of-range'],
    ['result', '178', 178],
    ['result', '2:58', 178],
    ['result', '2.58', '17800 or 258'],
    ['result', '45.5', 45.5],
    ['result', '2 30', 150],
    ['result', '3 min', 180],
    ['result', '230', 230],
    ['result', '1:75', 'not-a-time'],
    ['result', '-5', 'not-a-time'],
    ['result', '1.234', 'too-fine'],
    ['result', '36000', 36_000],
    ['result', '36000.01', 'out-of-range'],
  ])('%s from “%s”', (measure, text, wanted) => {
    const read = readMeasure(measure, text);
    const said = 'either' in read ? read.either.join(' or ') : 'value' in read ? read.value : read.unreadable;
    expect(said).toBe(wanted);
  });

  it('can be read back from its shown text, with a point or a comma', () => {
    fc.assert(
      fc.property(
        fc.constantFrom<Measure>('wind', 'temperature', 'result'),
        fc.integer({ min: 0, max: 1_000_000 }),
        (measure, number) => {
          const { min, max } = RANGES[measure];
          const value = min + (number % ((max - min) * 100 + 1)) / 100;
          const rounded = Math.round(value * 100) / 100;
          const text = measureText(rounded);
          const read = readMeasure(measure, text);
          // A short time with decimals may be minutes: then its own meaning is among the answers.
          if ('either' in read) expect(read.either.at(-1)).toBe(Math.round(rounded * 100));
          else expect(read).toEqual({ value: rounded });
          expect(readMeasure(measure, text.replace('.', ','))).toEqual(read);
        },
      ),
    );
  });

  it('steps to the next whole number, and never out of its range', () => {
    expect([steppedMeasure('wind', 3.5, 1), steppedMeasure('wind', 3.5, -1), steppedMeasure('wind', 3, -1)]).toEqual([
      4, 3, 2,
    ]);
    expect([
      steppedMeasure('wind', 0, -1),
      steppedMeasure('wind', 50, 1),
      steppedMeasure('temperature', -0.5, 1),
    ]).toEqual([0, 50, 0]);
  });
});
