import { type ReadonlySignal, useSignal } from '@preact/signals';
import { useLayoutEffect } from 'preact/hooks';
import { media } from '../browser/doors.js';

/** A phone, upright or on its side: there is room for one thing at a time. */
export const NARROW = '(max-width: 759.98px), (max-height: 479.98px)';

/** One line has no room for the memories beside model, figures and what is known: a tablet that is held upright. */
export const TIGHT = '(max-width: 1023.98px), (max-height: 479.98px)';

/** The ways to the views lie below: a phone that is held upright. On its side its height is dear. */
export const TABS_BELOW = '(max-width: 759.98px) and (min-height: 480px), (max-width: 559.98px)';

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
