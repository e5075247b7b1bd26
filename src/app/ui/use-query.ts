import { type ReadonlySignal, useSignal } from '@preact/signals';
import { useLayoutEffect, useMemo } from 'preact/hooks';
import { media } from '../browser/doors.js';

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
