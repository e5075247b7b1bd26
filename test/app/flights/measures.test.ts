import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  MEASURES,
  type Measure,
  measureText,
  RANGES,
  readMeasure,
  steppedMeasure,
} from '../../../src/app/flights/measures.js';

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
    ['result', '2:58,5', 178.5],
    ['result', '2.58.5', 178.5],
    ['result', '3 min', 180],
    ['result', '2 min 30 s', 150],
    ['result', '178,25 s', 178.25],
    ['result', '230', 230],
    ['result', '1:75', 'not-a-time'],
    ['result', '-5', 'not-a-time'],
    ['result', '1.234', 'too-fine'],
    ['result', '36000', 36_000],
    ['result', '36000.01', 'out-of-range'],
  ])('%s from “%s”', (measure, text, wanted) => {
    const read = readMeasure(measure, text);
    expect('value' in read ? read.value : read.unreadable).toBe(wanted);
  });

  it('can be read back from its shown text, with a point or a comma', () => {
    fc.assert(
      fc.property(fc.constantFrom(...MEASURES), fc.integer({ min: 0, max: 1_000_000 }), (measure, number) => {
        const { min, max } = RANGES[measure];
        const value = min + (number % ((max - min) * 100 + 1)) / 100;
        const rounded = Math.round(value * 100) / 100;
        const text = measureText(rounded);
        expect(readMeasure(measure, text)).toEqual({ value: rounded });
        expect(readMeasure(measure, text.replace('.', ','))).toEqual({ value: rounded });
      }),
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
