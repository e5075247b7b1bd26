import type { Page } from 'playwright';
import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { openHost, publish, update, visited } from './host.js';
import { newPage } from './page.js';

/**
 * Until the page is the new one. A worker that takes the place of another one waits in Chromium until that has finished
 * what it is doing, for up to five minutes.
 */
async function isTaken(page: Page): Promise<void> {
  await expect.poll(() => page.title(), { timeout: 400_000 }).toBe('A later version');
}

test('a new version is offered, also without a network, and can be used', async () => {
  const { host, page } = await visited();
  publish(host, 'A later version');
  expect(await update(page)).toBe('installed');
  await page.context().setOffline(true);
  await page.reload();
  await page.getByText(en.update.ready).waitFor();
  await page.getByRole('button', { name: en.update.take }).click();
  await isTaken(page);
  await page.getByRole('button', { name: 'Connect', exact: true }).waitFor();
  expect(
    await page.evaluate(async () => (await caches.keys()).length),
    'the older version is gone from the cache',
  ).toBe(1);
});

/** A file of a language that nobody has chosen. */
const UNSPOKEN = /^(?!en)[a-z]{2}-[\w-]{8}\.js$/;

test('all scripts are loaded early, so that a replaced version needs none of them from the host', async () => {
  const { page } = await visited();
  const names = (addresses: readonly string[]): string[] =>
    addresses.map((address) => address.replace(/.*\//, '')).filter((name) => name.endsWith('.js'));
  const kept = await page.evaluate(async () => {
    const [name = ''] = await caches.keys();
    return (await (await caches.open(name)).keys()).map(({ url }) => url);
  });
  const loaded = (): Promise<string[]> =>
    page.evaluate(() => performance.getEntriesByType('resource').map(({ name }) => name));
  await expect
    .poll(async () => {
      const now = names(await loaded());
      return names(kept).filter((name) => !now.includes(name) && !UNSPOKEN.test(name));
    })
    .toEqual([]);
});

test('a page that stays open looks for a new version each hour', async () => {
  const host = await openHost();
  let looks = 0;
  host.lie = (address) => {
    if (address === 'sw.js') looks++;
    return undefined;
  };
  const page = await newPage();
  await page.clock.install();
  await page.goto(host.url);
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  // Its looks at the start are over when one that was asked for later is.
  await page.evaluate(async () => (await navigator.serviceWorker.getRegistration())?.update());
  const before = looks;
  await page.clock.fastForward('50:00');
  await page.clock.fastForward('20:00');
  await expect.poll(() => looks).toBe(before + 1);
});
