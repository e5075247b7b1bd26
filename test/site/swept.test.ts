import { expect, test } from 'vitest';
import { AppPage } from './app-page.js';

/** The second test of this file gets the profile of the first. */
const OWN = { viewport: { width: 1234, height: 789 } };
let first: unknown;

test('a test leaves something of every kind in its profile,', async () => {
  const { page } = await AppPage.open({ ...OWN, bench: {} });
  first = page.context();
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  await page.evaluate(async () => {
    // biome-ignore lint/suspicious/noDocumentCookie: what another program could do.
    document.cookie = 'left=1; max-age=1000';
    localStorage.setItem('left', '1');
    sessionStorage.setItem('left', '1');
    await (await navigator.storage.getDirectory()).getFileHandle('left', { create: true });
    await new Promise((resolve) => {
      const opening = indexedDB.open('left');
      opening.onsuccess = resolve;
    });
  });
  await page.context().setOffline(true);
});

test('and the next test finds only the worker of the page', async () => {
  const { page } = await AppPage.open(OWN);
  expect(page.context(), 'the next test uses the same profile').toBe(first);
  const left = await page.evaluate(async () => {
    const files: string[] = [];
    const folder = (await navigator.storage.getDirectory()) as unknown as AsyncIterable<[string, unknown]>;
    for await (const [name] of folder) files.push(name);
    const databases = await indexedDB.databases();
    return [
      ...document.cookie.split('; '),
      ...Object.keys(localStorage),
      ...Object.keys(sessionStorage),
      ...databases.map(({ name }) => name),
      ...files,
      ...('workbench' in window ? ['workbench'] : []),
      ...(navigator.onLine ? [] : ['offline']),
    ];
  });
  expect(left.filter((name) => !name?.startsWith('sidus-timer'))).toEqual(['']);
  expect(await page.evaluate(() => navigator.serviceWorker.controller !== null)).toBe(true);
});
