import { isSame } from '../storage/index.js';

/** Beside what the storage needs of it, a record of the library holds one thing that a pilot knows. */
const INNER = ['model', 'setting', 'flight'] as const;
/** These belong to the values of a setting: when and how they came to be. */
const OF_VALUES: readonly string[] = ['at', 'from'];

/** What two tabs have made of one record. */
export interface Merged<T> {
  /** The changes of both; where they do not agree, what this tab wants. */
  readonly record: T;
  /** Where they do not agree, by the names of the fields. */
  readonly disagreed: readonly string[];
}

type Fields = Readonly<Record<string, unknown>>;

/**
 * Puts together what two tabs have made of one record at the same time.
 * @param before what both have begun with; undefined: each has made it.
 */
export function merged<T extends { readonly changedAt: number }>(before: T | undefined, mine: T, theirs: T): Merged<T> {
  const disagreed: string[] = [];
  const [was, other] = [(before ?? {}) as Fields, theirs as Fields];
  const record = mergedFields(was, mine as Fields, other, (name, value) => {
    if (!INNER.some((each) => each === name)) return value;
    return mergedFields((was[name] ?? {}) as Fields, value as Fields, other[name] as Fields, (field, wanted) => {
      if (name !== 'setting' || !OF_VALUES.includes(field)) disagreed.push(field);
      return wanted;
    });
  });
  const changedAt = Math.max(mine.changedAt, theirs.changedAt);
  return { record: { ...(record as unknown as T), changedAt }, disagreed };
}

/** @param both called for what both have changed, and not in the same way: by its name, with what this tab wants. */
function mergedFields(
  before: Fields,
  mine: Fields,
  theirs: Fields,
  both: (name: string, mine: unknown) => unknown,
): Fields {
  return Object.fromEntries(
    Object.keys({ ...theirs, ...mine }).map((name) => {
      const [was, value, other] = [before[name], mine[name], theirs[name]];
      if (isSame(value, other) || isSame(other, was)) return [name, value];
      return [name, isSame(value, was) ? other : both(name, value)];
    }),
  );
}
