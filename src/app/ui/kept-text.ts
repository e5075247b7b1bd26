import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { on } from '../browser/lifecycle.js';
import { useUnsaved } from './unsaved.js';

/**
 * A field whose text is kept when the pilot leaves it, or it goes away with its page.
 * @param value the text that is kept.
 * @param keep called with the typed text; it may be the same, or come again.
 */
export function useKeptText(value: string, keep: (text: string) => void) {
  /** Null while the kept text is shown. */
  const typed = useSignal<string | null>(null);
  const save = useRef(() => {});
  save.current = () => {
    if (typed.peek() !== null) keep(typed.peek() ?? '');
  };
  useEffect(() => on('hide', () => save.current()), []);
  useEffect(() => () => save.current(), []);
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
    },
    onBlur: (): void => {
      save.current();
      drop();
    },
  };
  return { given, drop };
}
