import { eraseSettings } from '../browser/settings.js';
import type { Erasers } from './erase.js';

/**
 * Empties what the browser keeps for this page beside its storage. Other programs at the same address are left alone.
 */
export function browserErasers(serial: Serial | undefined): Erasers {
  return {
    settings: async () => eraseSettings(),
    ports: async () => {
      for (const port of (await serial?.getPorts()) ?? []) await port.forget?.();
    },
    offline: async () => {
      const registration = await navigator.serviceWorker?.getRegistration();
      if (!registration) return;
      // Each worker names its caches by its own address.
      for (const name of await caches.keys()) if (name.endsWith(registration.scope)) await caches.delete(name);
      await registration.unregister();
    },
  };
}
