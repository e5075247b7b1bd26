import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { on } from '../browser/lifecycle.js';
import { useUnsaved } from './unsaved.js';

/**
 * A field whose text is kept when the pilot leaves it, or it goes away with its page.
 * @param value the text that is kept.
 * @param keep called with the typed text; it may be the same, or come again.
 * @param rest how long after the last key it is kept, too, in milliseconds: a long text must outlive a crash. Without
 * one only as above, so that it can be dropped.
 */
export function useKeptText(value: string, keep: (text: string) => void, rest?: number) {
  /** Null while the kept text is shown. */
  const typed = useSignal<string | null>(null);
  const save = useRef(() => {});
  const due = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  save.current = () => {
    if (typed.peek() !== null) keep(typed.peek() ?? '');
  };
  useEffect(() => on('hide', () => save.current()), []);
  useEffect(
    () => () => {
      clearTimeout(due.current);
      save.current();
    },
    [],
  );
  // A reload would take the field from under the pilot's fingers.
  useUnsaved(typed.value !== null);
  const drop = (): void => {
    typed.value = null;
  };
  const given = {
    value: typed.value ?? value,
    autocomplete: 'off' as const,
    onInput: (event: { readonly currentTarget: { readonly value: string } }): void => {
      typed.value = event.currentTarget.value;
      clearTimeout(due.current);
      if (rest !== undefined) due.current = setTimeout(() => save.current(), rest);
    },
    onBlur: (): void => {
      save.current();
      drop();
    },
  };
  return { given, drop };
}
