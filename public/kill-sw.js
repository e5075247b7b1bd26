// The way out, should a published version of Sidus Timer keep its own page from loading.
//
// Serve this file in the place of sw.js (copy it over sw.js on the host). Each browser fetches it at its next visit, at the latest a day
// later. It takes the place of the worker that is there, throws the kept page away and removes itself: from then on the page comes from
// the host. Drafts, backups and settings are not touched. A tab that is open loads the page again by itself, as soon as no port is open
// and what was typed is kept; one that shows nothing has to be loaded again by hand. When a good version is published, with its own sw.js,
// that is installed again.

self.addEventListener('install', () => self.skipWaiting());
self.addEventListener('activate', (event) => {
  const drop = async () => {
    const { scope } = self.registration;
    for (const name of await caches.keys()) if (name.endsWith(scope)) await caches.delete(name);
    await self.registration.unregister();
  };
  event.waitUntil(drop());
});
