/*
 * What Web IDL does to a value that a page hands to a method, before the method's own steps begin. A member of a
 * dictionary is converted as it is read, and members are read in the order of their names.
 */

/** A dictionary: any object; null and undefined are an empty one. @throws TypeError */
export function dictionary<T extends object>(value: T | null | undefined): Partial<T> {
  if (value === null || value === undefined) return {};
  if (typeof value === 'object' || typeof value === 'function') return value;
  throw new TypeError('The provided value is not an object.');
}

/** A sequence: what can be iterated, and is no text. @throws TypeError */
export function sequence<T>(value: readonly T[], name: string): T[] {
  const isObject = typeof value === 'object' && value !== null;
  if (!isObject || typeof value[Symbol.iterator] !== 'function') throw new TypeError(`${name} must be a list.`);
  return [...value];
}

/** An integer with [EnforceRange], from 0 to `max`. @throws TypeError also for a BigInt. */
export function integer(value: unknown, max: number, name: string): number {
  const number = Math.trunc(toNumber(value));
  // Also false for NaN.
  if (number >= 0 && number <= max) return number + 0;
  throw new TypeError(`${name} must be a number from 0 to ${max}.`);
}

/** An unsigned integer of so many bits: what is too large begins again at 0. @throws TypeError for a BigInt. */
export function unsigned(value: unknown, bits: number): number {
  const number = Math.trunc(toNumber(value));
  if (!Number.isFinite(number)) return 0;
  const size = 2 ** bits;
  return ((number % size) + size) % size;
}

/** A word of an enumeration. @throws TypeError */
export function oneOf(value: unknown, values: readonly string[], name: string): string {
  const word = `${value}`;
  if (values.includes(word)) return word;
  throw new TypeError(`${name} must be one of ${values.join(', ')}.`);
}

/** `Number(...)` would take a BigInt. */
function toNumber(value: unknown): number {
  return +(value as number);
}
