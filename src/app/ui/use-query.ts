import type { ReadonlySignal } from '@preact/signals';
import { useLayoutEffect, useMemo } from 'preact/hooks';
import { media } from '../browser/doors.js';
import { querySignal } from '../browser/query-signal.js';

/** Whether a media query matches. False where the browser does not tell. */
export function useQuery(query: string): ReadonlySignal<boolean> {
  const { matches, stop } = useMemo(() => querySignal(media(query)), [query]);
  useLayoutEffect(() => stop, [stop]);
  return matches;
}
