import { expect, inject, test } from 'vitest';
import { newPage } from './page.js';

test('a newer storage has its own sentence', async () => {
  const page = await newPage();
  await page.route('**/*', (route) => route.fulfill({ body: '<!doctype html>', contentType: 'text/html' }));
  await page.goto(inject('site'));
  await page.evaluate(
    () =>
      new Promise((resolve) => {
        const opening = indexedDB.open('sidus-timer', 1000);
        opening.onsuccess = () => resolve(opening.result.close());
      }),
  );
  await page.unroute('**/*');
  await page.goto(inject('site'));
  await page.getByText(/A newer version of this page has changed its storage/).waitFor();
});

test('inside of a frame the page does not work, and says where it does', async () => {
  const page = await newPage({}, []);
  await page.route('**/outer', (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<iframe src="${inject('site')}" width="600" height="400"></iframe>`,
    }),
  );
  // As from a host that cannot send the header which shuts frames out by itself.
  await page.route(inject('site'), async (route) => {
    const response = await route.fetch();
    const { 'content-security-policy': _, ...headers } = response.headers();
    await route.fulfill({ response, headers });
  });
  await page.goto(`${new URL(inject('site')).origin}/outer`);
  const frame = page.frameLocator('iframe');
  await frame.getByRole('heading', { name: 'Sidus Timer works only in a tab of its own.' }).waitFor();
  expect(await frame.getByRole('button').count()).toBe(0);
  expect(await frame.getByRole('link').getAttribute('href')).toBe(inject('site'));
  // Nothing was begun, or kept, that the other page could reach.
  const inside = page.frames().find((each) => each.url() === inject('site'));
  const left = await inside?.evaluate(async () => [
    (await indexedDB.databases()).length,
    (await navigator.serviceWorker.getRegistrations()).length,
    (await navigator.locks.query()).held?.length,
    (await caches.keys()).length,
    localStorage.length + sessionStorage.length,
    // Dark or light, it can be read: the theme was settled.
    document.documentElement.getAttribute('data-theme'),
  ]);
  expect(left).toEqual([0, 0, 0, 0, 0, 'light']);
});
