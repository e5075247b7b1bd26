import type { Surroundings } from '../../serial/index.js';
import { openTabChannel, type TabChannel } from './other-tabs.js';
import { keepsSettings } from './settings.js';
import { type Locks, TabNumber, tabMemory } from './tab-number.js';

/**
 * What a browser may not have for this page, besides its storage: `locks` tell its tabs apart, over the `channel` they speak with each
 * other, `settings` are small choices, `offline` is the page itself for when there is no network.
 */
export type Lack = 'locks' | 'channel' | 'settings' | 'offline';

/** As much of a media query as is used here. */
export type Query = Pick<MediaQueryList, 'matches' | 'addEventListener' | 'removeEventListener'>;

/** What the browser has for this page; null is what it does not have, or does not hand out. */
export interface Doors {
  readonly surroundings: Surroundings;
  readonly locks: Locks | null;
  readonly channel: TabChannel | null;
  /** Whether the system is dark. */
  readonly dark: Query | null;
  /** Whether small choices can be kept. */
  readonly settings: true | null;
}

/** How each door is opened. Each may throw, and each may give nothing. */
const WAYS: { readonly [Name in keyof Doors]: (page: Window & typeof globalThis) => Doors[Name] | undefined } = {
  surroundings: ({ navigator, isSecureContext, document }) => {
    const { featurePolicy } = document as { featurePolicy?: { allowsFeature(name: string): boolean } };
    return {
      serial: navigator.serial as Serial | undefined,
      isSecureContext,
      policyAllows: tried(() => featurePolicy?.allowsFeature('serial')) ?? undefined,
    };
  },
  locks: ({ navigator }) => navigator.locks as LockManager | undefined,
  channel: () => openTabChannel(),
  dark: ({ matchMedia }) => matchMedia('(prefers-color-scheme: dark)'),
  settings: () => (keepsSettings() ? true : null),
};

/** Opens what can be opened. Nothing here waits, and nothing throws. */
export function openDoors(page: Window & typeof globalThis = window): Doors {
  const open = <Name extends keyof Doors>(name: Name): Doors[Name] | null => tried(() => WAYS[name](page));
  return {
    surroundings: open('surroundings') ?? { serial: undefined, isSecureContext: page.isSecureContext },
    locks: open('locks'),
    channel: open('channel'),
    dark: open('dark'),
    settings: open('settings'),
  };
}

/** What is missing, and would be missed. The locks say so themselves, see {@link TabNumber}. */
export function lacksOf({ channel, settings }: Doors): Lack[] {
  return [...(channel ? [] : (['channel'] as const)), ...(settings ? [] : (['settings'] as const))];
}

export function tabNumberOf({ locks }: Doors): TabNumber {
  return new TabNumber(locks, tabMemory);
}

/** What this gives; null where it gives nothing or throws. */
export function tried<T>(work: () => T): NonNullable<T> | null {
  try {
    return work() ?? null;
  } catch {
    return null;
  }
}
