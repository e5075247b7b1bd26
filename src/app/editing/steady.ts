import { computed, type ReadonlySignal } from '@preact/signals';

/**
 * What is found, as the same object for as long as it says the same: who reads it is not drawn anew by a change elsewhere.
 * @param find of plain data, which are compared as JSON.
 */
export function steady<T>(find: () => T): ReadonlySignal<T> {
  let last: { readonly value: T; readonly text: string } | null = null;
  return computed(() => {
    const value = find();
    const text = JSON.stringify(value);
    if (last?.text !== text) last = { value, text };
    return last.value;
  });
}
