import { service } from '../browser/services.js';
import { eraseSettings } from '../browser/settings.js';
import type { Erasers } from './erase.js';

/** Deletes what the browser keeps for this page besides its storage. Other pages of the same origin keep theirs. */
export function browserErasers(serial: Pick<Serial, 'getPorts'> | null): Erasers {
  return {
    settings: async () => eraseSettings(),
    ports: async () => {
      for (const port of (await serial?.getPorts()) ?? []) await port.forget?.();
    },
    offline: async () => {
      const registration = await service('serviceWorker')?.getRegistration();
      if (!registration) return;
      // Each worker names its caches after its own address.
      const caches = service('caches');
      for (const name of (await caches?.keys()) ?? []) {
        if (name.endsWith(registration.scope)) await caches?.delete(name);
      }
      await registration.unregister();
    },
  };
}
