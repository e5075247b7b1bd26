import { computed, type ReadonlySignal } from '@preact/signals';

/**
 * A list that is computed again at each change. Equal items keep their object, and an equal list stays the same list.
 * So readers are drawn again only when something differs.
 * @param isSame whether a new item equals an old one.
 */
export function computedList<T>(
  find: () => readonly T[],
  isSame: (old: T, found: T) => boolean,
): ReadonlySignal<readonly T[]> {
  let last: readonly T[] = [];
  return computed(() => {
    const items = find().map((found) => last.find((old) => isSame(old, found)) ?? found);
    if (items.length !== last.length || items.some((item, at) => item !== last[at])) last = items;
    return last;
  });
}
