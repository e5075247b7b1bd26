import { expect, inject, test } from 'vitest';
import { newPage } from './page.js';

for (const site of ['site', 'siteUnderPath'] as const) {
  test(`after one visit to ${new URL(inject(site)).pathname} the page needs no network`, async () => {
    const page = await newPage();
    await page.goto(inject(site));
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    await page.context().setOffline(true);
    await page.reload();
    expect(await page.title()).toBe('Sidus Timer');
    await page.goto(`${inject(site)}?any=thing`);
    expect(await page.title()).toBe('Sidus Timer');
    await expect(page.goto(`${inject(site)}another-page`), 'the network is gone').rejects.toThrow('DISCONNECTED');
  });
}
