/*
 * What Web IDL does to a value that a page passes to a method, before the method's own steps begin. A member of a
 * dictionary is converted when it is read, and members are read in the order of their names.
 */

/** Converts to a dictionary, from any object. Null and undefined give an empty one. @throws TypeError */
export function dictionary<T extends object>(value: T | null | undefined): Partial<T> {
  if (value === null || value === undefined) return {};
  if (typeof value === 'object' || typeof value === 'function') return value;
  throw new TypeError('The provided value is not an object.');
}

/** Converts a member of a dictionary that may be left out. */
export function given<T, Converted>(value: T | undefined, by: (value: T) => Converted): Converted | undefined {
  return value === undefined ? undefined : by(value);
}

/** Without the members that are undefined. */
export function defined<T extends object>(of: T): { [Key in keyof T]: Exclude<T[Key], undefined> } {
  return Object.fromEntries(Object.entries(of).filter(([, value]) => value !== undefined)) as never;
}

/** Converts to a sequence, from anything that can be iterated and is not a text. @throws TypeError */
export function sequence<T>(value: readonly T[], name: string): T[] {
  const isObject = typeof value === 'object' && value !== null;
  if (!isObject || typeof value[Symbol.iterator] !== 'function') throw new TypeError(`${name} must be a list.`);
  return [...value];
}

/** Converts to an integer with [EnforceRange], from 0 to `max`. @throws TypeError also for a BigInt. */
export function integer(value: unknown, max: number, name: string): number {
  const number = Math.trunc(toNumber(value));
  // False for NaN, too.
  if (number >= 0 && number <= max) return number + 0;
  throw new TypeError(`${name} must be a number from 0 to ${max}.`);
}

/**
 * Converts to an unsigned integer of `bits` bits. A value that is too large wraps around. @throws TypeError for a
 * BigInt.
 */
export function unsigned(value: unknown, bits: number): number {
  const number = Math.trunc(toNumber(value));
  if (!Number.isFinite(number)) return 0;
  const size = 2 ** bits;
  return ((number % size) + size) % size;
}

/** Converts to a word of an enumeration. @throws TypeError */
export function oneOf(value: unknown, values: readonly string[], name: string): string {
  const word = `${value}`;
  if (values.includes(word)) return word;
  throw new TypeError(`${name} must be one of ${values.join(', ')}.`);
}

/** `Number(...)` would accept a BigInt. */
function toNumber(value: unknown): number {
  return +(value as number);
}

/**
 * Gives a class the face of an interface: its name in `Object.prototype.toString`, and members of its own that are seen
 * when somebody goes through them.
 */
export function asInterface(prototype: object, name: string, members: readonly string[]): void {
  Object.defineProperty(prototype, Symbol.toStringTag, { value: name, configurable: true });
  for (const member of members) {
    let holder: object | null = prototype;
    while (holder && !Object.hasOwn(holder, member)) holder = Object.getPrototypeOf(holder);
    const found = holder && Object.getOwnPropertyDescriptor(holder, member);
    if (found) Object.defineProperty(prototype, member, { ...found, enumerable: true });
  }
}
