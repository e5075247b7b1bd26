import type { SerialLike, Surroundings } from '../../serial/index.js';
import { openTabChannel, type TabChannel } from './other-tabs.js';
import { type Service, service, tried } from './services.js';
import { keepsSettings } from './settings.js';
import { TabNumber, tabMemory } from './tab-number.js';

/**
 * What a browser may not have for this page, besides its storage: `locks` tell its tabs apart, over the `channel` they
 * speak with each other, `settings` are small choices, `offline` is the page itself for when there is no network.
 */
export type Lack = 'locks' | 'channel' | 'settings' | 'offline';

/** As much of a media query as is used here. */
export type Query = Pick<MediaQueryList, 'matches' | 'addEventListener' | 'removeEventListener'>;

/** What the browser has for this page when it is opened; null is what it does not have, or does not hand out. */
export interface Doors {
  readonly surroundings: Surroundings;
  readonly locks: Service<'locks'> | null;
  readonly channel: TabChannel | null;
  readonly libraryChannel: TabChannel | null;
  /** Whether small choices can be kept. */
  readonly settings: boolean;
}

/** Opens what can be opened. Nothing here waits, and nothing throws. */
export function openDoors(): Doors {
  return {
    surroundings: {
      serial: (service('serial') as SerialLike | null) ?? undefined,
      isSecureContext: isSecureContext,
      policyAllows: tried(serialAllowed) ?? undefined,
    },
    locks: service('locks'),
    channel: tried(() => openTabChannel()),
    libraryChannel: tried(() => openTabChannel('library')),
    settings: keepsSettings(),
  };
}

/** What is missing, and would be missed. The locks say so themselves, see {@link TabNumber}. */
export function lacksOf({ channel, settings }: Doors): Lack[] {
  return [...(channel ? [] : (['channel'] as const)), ...(settings ? [] : (['settings'] as const))];
}

export function tabNumberOf({ locks }: Doors): TabNumber {
  return new TabNumber(locks, tabMemory);
}

/** What the browser knows of how a page is to be shown; null where it does not say. */
export function media(query: string): Query | null {
  return tried(() => service('matchMedia')?.(query));
}

function serialAllowed(): boolean | undefined {
  const { featurePolicy } = document as { featurePolicy?: { allowsFeature(name: string): boolean } };
  return featurePolicy?.allowsFeature('serial');
}
