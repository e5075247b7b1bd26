import { type ReadonlySignal, useSignal } from '@preact/signals';
import { useLayoutEffect, useMemo } from 'preact/hooks';
import { media } from '../browser/doors.js';

// The shapes of the window: test/tools/styles.js names them, and refuses any other threshold in the styles.

/** A phone, upright or on its side: it has room for one thing at a time. */
export const NARROW = '(max-width: 759.98px), (max-height: 479.98px)';

/** A tablet that is held upright: the strip has no room for the memories beside the other figures. */
export const TIGHT = '(max-width: 1099.98px), (max-height: 479.98px)';

/** A phone on its side, or a page at 200 %: the head scrolls, but for the line of the strip. */
export const LOW = '(max-height: 479.98px)';

/** A phone that is held upright: the links to the views stand at the bottom. On its side, height is too scarce. */
export const TABS_BELOW = '(max-width: 759.98px) and (min-height: 480px), (max-width: 559.98px)';

/** Whether a media query matches. False where the browser does not tell. */
export function useQuery(query: string): ReadonlySignal<boolean> {
  const list = useMemo(() => media(query), [query]);
  const matches = useSignal(list?.matches ?? false);
  useLayoutEffect(() => {
    const note = (): void => {
      matches.value = list?.matches ?? false;
    };
    note();
    list?.addEventListener?.('change', note);
    return () => list?.removeEventListener?.('change', note);
  }, [list, matches]);
  return matches;
}
