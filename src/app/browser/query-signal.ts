import { type ReadonlySignal, signal } from '@preact/signals';
import type { Query } from './doors.js';

/**
 * Follows a media query.
 * @param query null where the browser does not tell: then it never matches.
 * @returns whether it matches, and a function that ends this.
 */
export function querySignal(query: Query | null): { readonly matches: ReadonlySignal<boolean>; stop(): void } {
  const matches = signal(query?.matches ?? false);
  const note = (): void => {
    matches.value = query?.matches ?? false;
  };
  // For a long time Safari did not have these events.
  query?.addEventListener?.('change', note);
  return { matches, stop: () => query?.removeEventListener?.('change', note) };
}
