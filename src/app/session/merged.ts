import { isSame } from '../storage/index.js';

/** Besides what the storage needs, a record of the library holds one thing that a pilot knows. */
const INNER = ['model', 'setting', 'flight'] as const;
/** These fields go with the values of a setting: when and how they came about. */
const OF_VALUES: readonly string[] = ['at', 'from'];

/** Two tabs' versions of one record, merged. */
export interface Merged<T> {
  /** The changes of both. Where they do not agree, this tab's. */
  readonly record: T;
  /** The names of the fields on which they do not agree. */
  readonly disagreed: readonly string[];
}

type Fields = Readonly<Record<string, unknown>>;

/**
 * Merges what two tabs have made of one record at the same time.
 * @param before the version with which both began; undefined when each has made the record.
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

/** @param both called with the name of a field that both have changed in different ways, and with this tab's value. */
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
