import { useEffect } from 'preact/hooks';
import { onPageKey } from '../browser/page-keys.js';
import type { Views } from './views.js';

/**
 * The key `?` opens the help, except while somebody types. Ctrl+P or Cmd+P presses the button of the view that prints
 * sheets; where there is none, the browser prints the view. Neither does anything over a dialog.
 */
export function PageKeys({ views }: { readonly views: Views }) {
  useEffect(() => {
    const ends = [
      onPageKey('help', () => {
        if (hasDialog()) return false;
        views.show('help');
        return true;
      }),
      onPageKey('print', () => {
        const button = hasDialog() ? null : document.querySelector<HTMLElement>('[data-print]:not([disabled])');
        button?.click();
        return button !== null;
      }),
    ];
    return () => {
      for (const end of ends) end();
    };
  }, [views]);
  return null;
}

function hasDialog(): boolean {
  return document.querySelector('dialog[open]') !== null;
}
