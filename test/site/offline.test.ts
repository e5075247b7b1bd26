import { expect, inject, test } from 'vitest';
import { AppPage } from './app-page.js';

for (const at of ['site', 'siteUnderPath'] as const) {
  test(`after one visit to ${new URL(inject(at)).pathname} the page reads, writes and verifies without a network`, async () => {
    const app = await AppPage.open({ at, isFirstVisit: true });
    const { page } = app;
    await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
    await page.context().setOffline(true);
    await page.goto(`${inject(at)}?any=thing`);
    expect(await page.title()).toBe('Sidus Timer');
    await app.reload();
    await app.trySimulated('F1B');
    await app.type('DT time', '4:00');
    await app.kept();
    await app.write();
    await app.result('Verified.');
    await app.close();
    expect(await app.sets()).toEqual(['SETTIMERS']);
    await expect(page.goto(`${inject(at)}another-page`), 'the network is really gone').rejects.toThrow('DISCONNECTED');
  });
}
