import { type ReadonlySignal, useSignal, useSignalEffect } from '@preact/signals';
import type { Editor } from '../editing/editor.js';

/** A hand needs about as long from the keys to the mouse: what moves then has moved before it aims. In milliseconds. */
const REST = 400;

/** Changes when nothing has been edited for a while. */
export function useRested({ working, unreadable, asked, findings }: Editor): ReadonlySignal<unknown> {
  const rested = useSignal<unknown>(null);
  useSignalEffect(() => {
    const edited = [working.value, unreadable.value, asked.value, findings.value];
    const rest = setTimeout(() => {
      rested.value = edited;
    }, REST);
    return () => clearTimeout(rest);
  });
  return rested;
}
