import { SiteCache, type SiteFile } from './browser/worker-cache.js';

/** The part of a service worker's world that is used here. The types of a page do not have it. */
interface WorkerEvent extends Event {
  waitUntil(work: Promise<unknown>): void;
}
interface WorkerScope {
  readonly registration: { readonly scope: string };
  readonly clients: { claim(): Promise<void> };
  skipWaiting(): Promise<void>;
  /** The build fills it in. */
  readonly __WB_MANIFEST: readonly SiteFile[];
  addEventListener(type: 'install' | 'activate', listener: (event: WorkerEvent) => void): void;
  addEventListener(type: 'message', listener: (event: MessageEvent<{ type?: unknown } | null>) => void): void;
  addEventListener(
    type: 'fetch',
    listener: (
      event: WorkerEvent & { readonly request: Request; respondWith(response: Promise<Response>): void },
    ) => void,
  ): void;
}
declare const self: WorkerScope;

const site = new SiteCache(self.__WB_MANIFEST, self.registration.scope);

self.addEventListener('install', (event) => event.waitUntil(site.fill()));
// The first visit works offline at once, without a reload.
self.addEventListener('activate', (event) => event.waitUntil(site.dropOthers().then(() => self.clients.claim())));
// A new version waits until the pilot accepts it: see offline.ts.
self.addEventListener('message', ({ data }) => {
  if (data?.type === 'SKIP_WAITING') void self.skipWaiting();
});
self.addEventListener('fetch', (event) => {
  const { request } = event;
  const address = site.addressOf(request);
  if (address) event.respondWith(site.answer(address, request));
});
