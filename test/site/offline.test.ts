import { expect, inject, test } from 'vitest';
import { AppPage } from './app-page.js';
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
    await expect(page.goto(`${inject(site)}another-page`), 'the network is really gone').rejects.toThrow(
      'DISCONNECTED',
    );
  });

  test(`without a network the page at ${new URL(inject(site)).pathname} reads, writes and verifies`, async () => {
    const app = await AppPage.open({ at: site, isFirstVisit: true });
    await app.page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    await app.page.context().setOffline(true);
    await app.reload();
    await app.trySimulated('F1B');
    await app.type('DT time', '4:00');
    await app.kept();
    await app.write();
    await app.result('Verified.');
    await app.close();
    expect(await app.sets()).toEqual(['SETTIMERS']);
  });
}
