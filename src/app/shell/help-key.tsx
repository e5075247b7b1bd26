import { useEffect } from 'preact/hooks';
import type { Views } from './views.js';

/** The key `?` opens the help, except while somebody types or a dialog is open. */
export function HelpKey({ views }: { readonly views: Views }) {
  useEffect(() => {
    const onKey = (event: KeyboardEvent): void => {
      const { target, key, ctrlKey, metaKey, altKey } = event;
      const isTyped =
        target instanceof Element && target.closest('input, textarea, select, [contenteditable]') !== null;
      if (key !== '?' || ctrlKey || metaKey || altKey || isTyped) return;
      if (document.querySelector('dialog[open]') !== null) return;
      event.preventDefault();
      views.show('help');
    };
    document.addEventListener('keydown', onKey);
    return () => document.removeEventListener('keydown', onKey);
  }, [views]);
  return null;
}
