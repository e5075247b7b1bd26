import { useEffect } from 'preact/hooks';
import { takePageKey } from '../browser/page-keys.js';
import type { Views } from './views.js';

/** The key `?` opens the help, except while somebody types or a dialog is open. */
export function HelpKey({ views }: { readonly views: Views }) {
  useEffect(
    () =>
      takePageKey('help', () => {
        if (document.querySelector('dialog[open]') !== null) return false;
        views.show('help');
        return true;
      }),
    [views],
  );
  return null;
}
