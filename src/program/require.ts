import { CodecError, type CodecErrorCode } from '../protocol/index.js';

/*
 * Checks of values from outside. Each makes sure that a value is of its kind. `path` is the place that an error names:
 * `settings[3].name`.
 */

/** An object that may have the fields of `T`, each with any value. */
export type Raw<T> = { readonly [Name in keyof T]?: unknown };

/** The latest time that a JavaScript `Date` can hold, in milliseconds since 1970. */
export const LAST_DATE = 8.64e15;

/** Puts `path` before the field of an error that the check throws. */
export function within(path: string, check: () => void): void {
  try {
    check();
  } catch (cause) {
    if (!(cause instanceof CodecError)) throw cause;
    throw new CodecError(cause.code, `${path}.${cause.field}`, `${path}.${cause.message}`, cause.details);
  }
}

/** @param limits also `verb`, where it must not be, but have, what is wanted. */
export function refuse(
  code: CodecErrorCode,
  field: string,
  wanted: string,
  value: unknown,
  { verb = 'be', ...limits }: { min?: number; max?: number; verb?: 'be' | 'have' } = {},
): never {
  throw new CodecError(code, field, `${field} must ${verb} ${wanted}`, { value, ...limits, wanted });
}

export function record<T>(value: unknown, path: string): Raw<T> {
  if (typeof value !== 'object' || value === null || Array.isArray(value))
    refuse('wrong-type', path, 'an object', value);
  return value;
}

export function list(value: unknown, path: string, most: number): readonly unknown[] {
  if (!Array.isArray(value)) refuse('wrong-type', path, 'a list', value);
  if (value.length > most) {
    refuse('wrong-count', path, `at most ${most} entries`, value.length, { max: most, verb: 'have' });
  }
  return value;
}

/** @throws CodecError `wrong-count` unless the list has so many entries. */
export function requireCount({ length }: readonly unknown[], path: string, count: number): void {
  if (length === count) return;
  const wanted = `${count} entries`;
  const details = { value: length, min: count, max: count, wanted };
  throw new CodecError('wrong-count', path, `${path} must have ${wanted}, not ${length}`, details);
}

export function text(value: unknown, path: string, longest: number, shortest = 0): string {
  if (typeof value !== 'string') refuse('wrong-type', path, 'a text', value);
  const length = characters(value, longest);
  if (length < shortest || length > longest) {
    const limits = { min: shortest, max: longest, verb: 'have' } as const;
    refuse('out-of-range', path, `${shortest} to ${longest} characters`, length, limits);
  }
  return value;
}

/** How many characters a text has, counted as JSON Schema does. A text that is far too long is not counted through. */
function characters(value: string, longest: number): number {
  return value.length <= longest || value.length > 2 * longest ? value.length : [...value].length;
}

export function id(value: unknown, path: string): string {
  if (typeof value !== 'string' || !/^[A-Za-z0-9_-]{1,64}$/.test(value)) {
    refuse('wrong-type', path, '1 to 64 letters, digits, - or _', value);
  }
  return value;
}

/** For a value that may be missing; null counts as missing. */
export function optional<T>(value: unknown, check: (given: unknown) => T): T | null {
  return value === null || value === undefined ? null : check(value);
}

export function flag(value: unknown, path: string): boolean {
  if (typeof value !== 'boolean') refuse('wrong-type', path, 'true or false', value);
  return value;
}

export function date(value: unknown, path: string): number {
  return whole(value, path, 0, LAST_DATE);
}

export function whole(value: unknown, path: string, min: number, max: number): number {
  if (!Number.isInteger(value)) refuse('not-an-integer', path, 'a whole number', value);
  return measured(value, path, min, max) as number;
}

/** A list of whole numbers from 0 on. The path of a number is made only for an error: a library has 100,000 numbers. */
export function wholes(value: unknown, path: string, most: number, max: number): number[] {
  return list(value, path, most).map((each, at) =>
    Number.isInteger(each) && (each as number) >= 0 && (each as number) <= max
      ? (each as number) + 0
      : whole(each, `${path}[${at}]`, 0, max),
  );
}

export function measured(value: unknown, path: string, min: number, max: number): number | null {
  if (value === null || value === undefined) return null;
  if (typeof value !== 'number' || Number.isNaN(value)) refuse('wrong-type', path, 'a number, or null', value);
  if (value < min || value > max) refuse('out-of-range', path, `${min} to ${max}`, value, { min, max });
  // Turns -0 into 0: a negative zero would not come back from a file.
  return value + 0;
}

export function word<T extends string>(value: unknown, path: string, words: readonly T[]): T {
  const found = words.find((each) => each === value);
  if (found === undefined) refuse('unknown-word', path, `one of ${words.join(', ')}`, value);
  return found;
}
