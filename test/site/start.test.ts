import { expect, inject, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage, edgesOf } from './app-page.js';
import { newPage, PHONE } from './page.js';

const ANDROID =
  'Mozilla/5.0 (Linux; Android 17; Pixel 8) AppleWebKit/537.36 (KHTML, like Gecko) Chrome/149.0.0.0 Mobile Safari/537.36';

test.each([
  [390, 844],
  [360, 740],
])('a first visit on a phone of %i by %i has both ways to a timer in sight', async (width, height) => {
  const app = await AppPage.open({ ...PHONE, userAgent: ANDROID, viewport: { width, height }, bench: {} });
  await app.page.getByText(en.start.android).waitFor();
  const ways = [en.header.connect, ...['F1Q', 'F1B', 'F1E'].map((name) => en.start.simulated({ name }))];
  for (const name of ways) expect((await edgesOf(app.button(name))).bottom, name).toBeLessThanOrEqual(height);
});

test('inside a frame the page does not work, and says where it does', async () => {
  const page = await newPage({}, []);
  await page.route('**/outer', (route) =>
    route.fulfill({
      contentType: 'text/html',
      body: `<iframe src="${inject('site')}" width="600" height="400"></iframe>`,
    }),
  );
  // As from a host that cannot send the header against frames.
  await page.route(inject('site'), async (route) => {
    const response = await route.fetch();
    const { 'content-security-policy': _, ...headers } = response.headers();
    await route.fulfill({ response, headers });
  });
  await page.goto(`${new URL(inject('site')).origin}/outer`);
  const frame = page.frameLocator('iframe');
  await frame.getByRole('heading', { name: en.framed.title }).waitFor();
  await expect.poll(() => frame.getByRole('button').count()).toBe(0);
  await expect.poll(() => frame.getByRole('link').getAttribute('href')).toBe(inject('site'));
  // Nothing was started or stored that the other page could reach.
  const inside = page.frames().find((each) => each.url() === inject('site'));
  const left = await inside?.evaluate(async () => [
    (await indexedDB.databases()).length,
    (await navigator.serviceWorker.getRegistrations()).length,
    (await navigator.locks.query()).held?.length,
    (await caches.keys()).length,
    localStorage.length + sessionStorage.length,
    // It can be read in dark and light: the theme is set.
    document.documentElement.getAttribute('data-theme'),
  ]);
  expect(left).toEqual([0, 0, 0, 0, 0, 'light']);
});
