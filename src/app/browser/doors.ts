import type { SerialLike, Surroundings } from '../../serial/index.js';
import { openTabChannel, type TabChannel } from './other-tabs.js';
import { type Service, service, tried } from './services.js';
import { keepsSettings } from './settings.js';
import { TabNumber, tabMemory } from './tab-number.js';

/**
 * What the browser may lack for this page, besides its storage. `locks` tell tabs apart. Over the `channel` the tabs
 * talk to each other. `settings` are small choices. `offline`: the page kept for use without a network. `emptied`: what
 * its storage held until it was deleted.
 */
export type Lack = 'locks' | 'channel' | 'settings' | 'offline' | 'emptied';

/** The part of a media query that the page uses. */
export type Query = Pick<MediaQueryList, 'matches' | 'addEventListener' | 'removeEventListener'>;

/** What the browser offers this page when it opens; null is what it does not have, or refuses. */
export interface Doors {
  readonly surroundings: Surroundings;
  readonly locks: Service<'locks'> | null;
  readonly channel: TabChannel | null;
  readonly libraryChannel: TabChannel | null;
  /** Whether small choices can be kept. */
  readonly settings: boolean;
}

/** Opens everything that can be opened. Never waits and never throws. */
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

/** What is missing and would be missed. {@link TabNumber} reports the locks itself. */
export function lacksOf({ channel, settings }: Doors): Lack[] {
  return [...(channel ? [] : (['channel'] as const)), ...(settings ? [] : (['settings'] as const))];
}

export function tabNumberOf({ locks }: Doors): TabNumber {
  return new TabNumber(locks, tabMemory);
}

/** What a media query says; null where the browser does not tell. */
export function media(query: string): Query | null {
  return tried(() => service('matchMedia')?.(query));
}

function serialAllowed(): boolean | undefined {
  const { featurePolicy } = document as { featurePolicy?: { allowsFeature(name: string): boolean } };
  return featurePolicy?.allowsFeature('serial');
}
