// The way out, if a published version of Sidus Timer keeps its own page from loading.
//
// Copy this file over sw.js on the host. Each browser loads it at its next visit, at the latest a day later. It
// replaces the worker that is there, removes the kept page, and then itself: from then on the page comes from the host.
// Drafts, backups and settings stay. An open tab loads the page again by itself, as soon as no port is open and what
// was typed is kept. A tab that shows nothing has to be loaded again by hand. When you publish a good version with its
// own sw.js, that is installed again.

self.addEventListener('install', () => self.skipWaiting());
self.addEventListener('activate', (event) => {
  const drop = async () => {
    const { scope } = self.registration;
    for (const name of await caches.keys()) if (name.endsWith(scope)) await caches.delete(name);
    await self.registration.unregister();
  };
  event.waitUntil(drop());
});
