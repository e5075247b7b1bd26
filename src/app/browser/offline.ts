import { on } from './lifecycle.js';
import { nameplate, service } from './services.js';

/** How often a page that stays open looks for a new version, in milliseconds. */
const LOOK_AGAIN = 3_600_000;

export interface OfflineOptions {
  /** A new version waits; `take` starts it in place of this one. Called again for each that replaces a waiting one. */
  readonly onUpdateReady: (take: () => void) => void;
  /**
   * Calls back once, as soon as no port is open; at once if none is. Only then a new version replaces this one, and
   * only then the page loads again.
   */
  readonly whenFree: (callback: () => void) => void;
  /** This version is completely kept for use without a network. */
  readonly onKept: () => void;
}

/** Keeps the page for use without a network, and offers its new versions. Does nothing in development. */
export function registerOffline({ onUpdateReady, whenFree, onKept }: OfflineOptions): void {
  if (!import.meta.env.PROD) return;
  const serviceWorker = service('serviceWorker');
  if (!serviceWorker) return;

  // The first worker ever takes over a page of its own version. Every later worker brings a newer page.
  let replacing = serviceWorker.controller !== null;
  // A worker that controls the page has all of it.
  if (replacing) onKept();
  serviceWorker.addEventListener('controllerchange', () => {
    // The browser has deleted what it kept for this page: what is on the screen may be all that is left of it.
    if (serviceWorker.controller === null) return;
    if (replacing) whenFree(() => location.reload());
    else onKept();
    replacing = true;
  });

  const register = async (): Promise<void> => {
    const registration = await serviceWorker.register(workerAddress());
    const takeWaiting = (): void => {
      replacing = true;
      registration.waiting?.postMessage({ type: 'SKIP_WAITING' });
    };
    const offer = (): void => {
      const { waiting, active } = registration;
      if (waiting && active) onUpdateReady(() => whenFree(takeWaiting));
    };
    offer();
    // The page was loaded past the worker, as some keys do. It is completely kept all the same.
    if (registration.active && !registration.waiting) onKept();
    registration.addEventListener('updatefound', () => {
      const { installing } = registration;
      installing?.addEventListener('statechange', () => installing.state === 'installed' && offer());
    });
    lookAgain(() => registration.update());
    await registration.update();
  };
  // Without a network, or where nothing may be kept, the page works all the same.
  const start = (): void => void register().catch(() => {});
  if (document.readyState === 'complete') start();
  else addEventListener('load', start, { once: true });
}

/**
 * Looks for a new version now and then while the page stays open, perhaps for days,
 * and when the pilot comes back to it.
 */
function lookAgain(look: () => Promise<unknown>): void {
  let last = Date.now();
  const lookIfDue = (): void => {
    if (document.hidden || !nameplate().onLine || Date.now() - last < LOOK_AGAIN) return;
    last = Date.now();
    // Whatever went wrong here does not concern the pilot.
    look().catch(() => {});
  };
  setInterval(lookIfDue, LOOK_AGAIN / 4);
  on('return', lookIfDue);
}

/** The one address that the page's Trusted Types policy allows. */
function workerAddress(): string {
  const address = './sw.js';
  const policy = window.trustedTypes?.createPolicy('service-worker', { createScriptURL: (_: string) => address });
  return (policy?.createScriptURL(address) ?? address) as string;
}
