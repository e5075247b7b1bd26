import { computed, type ReadonlySignal } from '@preact/signals';

/**
 * A list that is found again at each change. Items that are the same stay the same objects, and a list of the same
 * items the same list: who reads it is drawn again only when it says something else.
 * @param isSame whether a new item says what an old one said.
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
