import { type Ambiguous, numberText, parseTime, plainDigits, readTime } from '../editing/units.js';

/*
 * Converts between what a pilot types with cold hands and the numbers of a flight: with comma or point, with or without
 * the unit.
 */

/**
 * The numbers that a flight has: wind in metres per second, temperature in degrees Celsius, result in seconds. With the
 * range of each, as in `Flight`, and the first value where none was noted before.
 */
export const RANGES = {
  wind: { min: 0, max: 50, first: 2 },
  temperature: { min: -50, max: 60, first: 15 },
  result: { min: 0, max: 36_000, first: 180 },
  /** The longest result that counts. */
  maximum: { min: 1, max: 36_000, first: 180 },
} as const;
export type Measure = keyof typeof RANGES;

/** A number; null for an empty text; the two or more that a text may mean; or why it is no number. */
export type ReadMeasure =
  | { readonly value: number | null }
  /** In hundredths of a second, as where a DT is typed. */
  | { readonly unreadable: 'ambiguous'; readonly either: Ambiguous['either'] }
  | { readonly unreadable: 'not-a-number' | 'not-a-time' | 'too-fine' | 'out-of-range' };

const NUMBER = /^[+-]?(?:\d{1,6}(?:[.,]\d{0,6})?|[.,]\d{1,6})$/;
const UNITS: Readonly<Record<'wind' | 'temperature', RegExp>> = {
  wind: /\s*(?:m\/s|м\/с)$/i,
  temperature: /\s*(?:°\s*[cс]?|c)$/i,
};

/**
 * Reads `3`, `3,5`, `-2.5`, `4 m/s`, `12 °C`; a result also as `2:58`, `2'58`, `2 58`, `2m58s`
 * and `3 min`. A result of `2.58` may be minutes and seconds, or seconds. Empty text: nothing noted.
 */
export function readMeasure(measure: Measure, text: string): ReadMeasure {
  const trimmed = plainDigits(text);
  if (trimmed === '') return { value: null };
  const read =
    measure === 'result' || measure === 'maximum'
      ? readResult(trimmed)
      : readNumber(trimmed.replace(UNITS[measure], ''));
  if ('unreadable' in read || read.value === null) return read;
  const { min, max } = RANGES[measure];
  return read.value < min || read.value > max ? { unreadable: 'out-of-range' } : read;
}

/** A number in the form of its field. A result stays in seconds, as on a score card. */
export function measureText(value: number | null): string {
  return value === null ? '' : numberText(value);
}

/** The next whole number up or down, within the range. */
export function steppedMeasure(measure: Measure, value: number, direction: 1 | -1): number {
  const { min, max } = RANGES[measure];
  return Math.min(max, Math.max(min, direction > 0 ? Math.floor(value) + 1 : Math.ceil(value) - 1));
}

function readResult(text: string): ReadMeasure {
  // As where a DT is typed. But whole seconds are the rule here: `230` is no question.
  const read = /^\d+$/.test(text) ? parseTime(text) : readTime(text, { isDt: true });
  if (!('unreadable' in read)) return { value: read.value / 100 };
  if ('either' in read) return read;
  return { unreadable: read.unreadable === 'too-fine' ? 'too-fine' : 'not-a-time' };
}

function readNumber(text: string): ReadMeasure {
  if (!NUMBER.test(text)) return { unreadable: 'not-a-number' };
  // No -0: it would not come back from a file.
  return { value: Number(text.replace(',', '.')) + 0 };
}
