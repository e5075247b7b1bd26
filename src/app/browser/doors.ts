import type { SerialLike, Surroundings } from '../../serial/index.js';
import { service, tried } from './services.js';

/**
 * What the browser may lack for this page, besides its storage. `tabs`: it does not say whether another tab works.
 * `settings` are small choices, and what was tried on the bench. `emptied`: what its storage held until it was deleted.
 */
export type Lack = 'tabs' | 'settings' | 'emptied';

/** The part of a media query that the page uses. */
export type Query = Pick<MediaQueryList, 'matches' | 'addEventListener' | 'removeEventListener'>;

/** What the browser offers for timers. Never waits and never throws. */
export function surroundings(): Surroundings {
  return {
    serial: (service('serial') as SerialLike | null) ?? undefined,
    isSecureContext: isSecureContext,
    policyAllows: tried(serialAllowed) ?? undefined,
  };
}

/** What a media query says; null where the browser does not tell. */
export function media(query: string): Query | null {
  return tried(() => service('matchMedia')?.(query));
}

function serialAllowed(): boolean | undefined {
  const { featurePolicy } = document as { featurePolicy?: { allowsFeature(name: string): boolean } };
  return featurePolicy?.allowsFeature('serial');
}
