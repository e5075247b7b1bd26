import { expect, test } from 'vitest';
import { parseLibraryFile } from '../../src/program/index.js';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { downloadedBy, makeModel, makeProgram } from './library.js';

/** All that the browser keeps for this address. */
function kept({ page }: AppPage) {
  return page.evaluate(async () => ({
    databases: (await indexedDB.databases()).map(({ name }) => name),
    settings: [...Object.keys(localStorage), ...Object.keys(sessionStorage)],
    caches: await caches.keys(),
    workers: (await navigator.serviceWorker.getRegistrations()).length,
  }));
}

test('everything that the page keeps is deleted, and nothing of another program at this address', async () => {
  const app = await AppPage.open({ bench: { granted: true }, isFirstVisit: true });
  const { page } = app;
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  await app.connect();
  await app.type('DT time', '4:00');
  await app.kept();
  await app.goTo('Settings');
  await page.getByText('Dark', { exact: true }).click();
  await page.evaluate(async () => {
    localStorage.setItem('another program', '1');
    await caches.open('another program');
    await new Promise((resolve) => {
      const opening = indexedDB.open('another program');
      opening.onsuccess = () => resolve(opening.result.close());
    });
  });
  const before = await kept(app);
  expect(before.databases).toContain('sidus-timer');
  expect([before.settings, before.caches, before.workers]).toEqual([
    expect.arrayContaining(['sidus-timer/theme']),
    [expect.stringContaining('sidus-timer'), 'another program'],
    1,
  ]);
  // A page that starts afresh would store something again, so an empty page replaces it.
  const forgotten = page.evaluate(
    () =>
      new Promise((resolve) => {
        const { port } = window.workbench.adapter;
        const own = port.forget.bind(port);
        port.forget = async () => {
          await own();
          resolve((await navigator.serial.getPorts()).length);
        };
      }),
  );
  await page.route('**/*', (route) =>
    route.fulfill({ body: '<!doctype html><title>Empty</title>', contentType: 'text/html' }),
  );
  await app.button(en.erase.open).click();
  await app.button(en.erase.start).click();
  expect(await forgotten, 'the right to use the port is given back').toBe(0);
  await page.waitForFunction(() => document.title === 'Empty');
  const { settings, ...rest } = await kept(app);
  expect(rest).toEqual({ databases: ['another program'], caches: ['another program'], workers: 0 });
  // The workbench keeps its timer through a reload.
  expect(settings.filter((name) => name !== 'workbench')).toEqual(['another program']);
});

test('when the browser deletes everything that it kept, the page stays, says so, and offers the export', async () => {
  const app = await AppPage.open();
  const { page } = app;
  await page.evaluate(() => location.assign('#library'));
  await makeModel(app, 'Lancer 07');
  await makeProgram(app, 'calm');
  await page.evaluate(() => void Object.assign(window, { stays: true }));
  const devTools = await page.context().newCDPSession(page);
  const { origin } = new URL(page.url());
  await devTools.send('Storage.clearDataForOrigin', { origin, storageTypes: 'all' });
  await app.says(en.keeping.emptied);
  const { text } = await downloadedBy(app, () => app.button(en.keeping.export).click());
  const { library } = parseLibraryFile(text);
  expect([library.models[0]?.name, library.settings[0]?.name]).toEqual(['Lancer 07', 'calm']);
  expect(await page.evaluate(() => navigator.serviceWorker.controller)).toBeNull();
  expect(await page.evaluate(() => 'stays' in window), 'it was not loaded again').toBe(true);
});
