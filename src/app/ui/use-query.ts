import { type ReadonlySignal, useSignal } from '@preact/signals';
import { useLayoutEffect } from 'preact/hooks';
import { media } from '../browser/doors.js';

/** The width from which there is room for a rail beside the view; below it the page is laid out for a phone. */
export const NARROW = '(max-width: 759.98px)';

/** Whether the window is as a media query says. Where a browser does not tell: no. */
export function useQuery(query: string): ReadonlySignal<boolean> {
  const matches = useSignal(media(query)?.matches ?? false);
  useLayoutEffect(() => {
    const list = media(query);
    const note = (): void => {
      matches.value = list?.matches ?? false;
    };
    note();
    list?.addEventListener?.('change', note);
    return () => list?.removeEventListener?.('change', note);
  }, [query, matches]);
  return matches;
}
