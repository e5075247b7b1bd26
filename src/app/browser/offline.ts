import { answerOf, nameplate, service } from './services.js';
import { type News, newsOfWaiting } from './update-news.js';

/** A page that stays open looks for a new version after so long, in milliseconds. */
const LOOK_AGAIN = 3_600_000;
/** So long the worker's script may take to come, in milliseconds: after that it is said that the page is not kept. */
const FETCHED = 10_000;

export interface OfflineOptions {
  /**
   * A new version waits: `take` puts it in place of this one. What is new in it comes later; null when it does not say.
   * Comes again for each that replaces the waiting one.
   */
  readonly onUpdateReady: (take: () => void, news: Promise<News | null>) => void;
  /**
   * Calls back, once, as soon as no port is open; at once if none is. Only then does a new version take the place of
   * this one, and only then is the page loaded again, also when another tab has taken it.
   */
  readonly whenFree: (callback: () => void) => void;
  /** All of this version is kept for use without a network. */
  readonly onKept: () => void;
  /** The browser does not keep the page for use without a network. */
  readonly onMissing: () => void;
}

/** Keeps the page for use without a network, and offers its new versions. Does nothing in development. */
export function registerOffline({ onUpdateReady, whenFree, onKept, onMissing }: OfflineOptions): void {
  if (!import.meta.env.PROD) return;
  const serviceWorker = service('serviceWorker');
  if (!serviceWorker) {
    onMissing();
    return;
  }

  // The first worker of all takes charge of a page that is as new as itself; every other brings a newer page.
  let replacing = serviceWorker.controller !== null;
  // Whoever answers for the page has all of it.
  if (replacing) onKept();
  serviceWorker.addEventListener('controllerchange', () => {
    if (replacing) whenFree(() => location.reload());
    else onKept();
    replacing = true;
  });

  const register = async (): Promise<void> => {
    const registering = serviceWorker.register(workerAddress());
    answerOf(() => registering, FETCHED).catch(failed);
    const registration = await registering;
    const takeWaiting = (): void => {
      replacing = true;
      registration.waiting?.postMessage({ type: 'SKIP_WAITING' });
    };
    const offer = (): void => {
      const { waiting, active } = registration;
      if (waiting && active) onUpdateReady(() => whenFree(takeWaiting), newsOfWaiting(waiting));
    };
    offer();
    // Loaded past the worker, as some keys do: all of it is kept all the same.
    if (registration.active && !registration.waiting) onKept();
    registration.addEventListener('updatefound', () => {
      const { installing } = registration;
      installing?.addEventListener('statechange', () => installing.state === 'installed' && offer());
    });
    lookAgain(() => registration.update());
    await registration.update();
  };
  // Without a network, or where nothing may be kept, the page works anyway.
  const failed = (): void => {
    if (serviceWorker.controller === null && nameplate().onLine) onMissing();
  };
  const start = (): void => void register().catch(failed);
  if (document.readyState === 'complete') start();
  else addEventListener('load', start, { once: true });
}

/** Looks for a new version while the page stays open, for days perhaps: now and then, and when it is come back to. */
function lookAgain(look: () => Promise<unknown>): void {
  let last = Date.now();
  const lookIfDue = (): void => {
    if (document.hidden || !nameplate().onLine || Date.now() - last < LOOK_AGAIN) return;
    last = Date.now();
    // Whatever is in the way, it is nothing to a pilot.
    look().catch(() => {});
  };
  setInterval(lookIfDue, LOOK_AGAIN / 4);
  document.addEventListener('visibilitychange', lookIfDue);
  addEventListener('online', lookIfDue);
}

/** The one address that the page's Trusted Types policy gives out. */
function workerAddress(): string {
  const address = './sw.js';
  const policy = window.trustedTypes?.createPolicy('service-worker', { createScriptURL: (_: string) => address });
  return (policy?.createScriptURL(address) ?? address) as string;
}
