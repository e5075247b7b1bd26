import { expect, test } from 'vitest';
import { AppPage } from './app-page.js';

test('after one visit a whole day on the field needs no network: connect, edit, write, library, print, help', async () => {
  const app = await AppPage.open();
  const { page } = app;
  await app.text('Ready offline').waitFor();
  await page.context().setOffline(true);
  await app.reload();
  await app.text('Ready offline').waitFor();
  expect(await page.evaluate(() => navigator.onLine)).toBe(false);

  await app.trySimulated('F1Q');
  await app.type('DT time', '4:00');
  await app.write();
  await app.result('Verified.');
  await app.close();

  await app.goTo('Library');
  await page.getByRole('heading', { level: 1 }).waitFor();
  await page.evaluate(() => location.assign('#print'));
  await page.getByRole('button', { name: /^Print \d+ page/ }).waitFor();

  await page.evaluate(() => location.assign('#help/checklist'));
  await app.text(/^M1 flies next, DT 4:00 min, read /).waitFor();
  for (const [link, heading] of [
    ['Trouble', 'When something is wrong'],
    ['Values', 'What the values are'],
    ['Energy', 'Energy for F1Q'],
    ['First steps', 'First steps'],
  ] as const) {
    await page.getByRole('link', { name: link, exact: true }).click();
    await page.getByRole('heading', { level: 2, name: heading }).waitFor();
  }
  await page.goBack();
  await page.getByRole('heading', { level: 2, name: 'Energy for F1Q' }).waitFor();

  await app.goTo('Settings');
  await app.text('All of it is on this device').waitFor();
  await app.text('What is new').click();
  await page.getByRole('heading', { level: 3, name: /^Version / }).waitFor();
  await app.text('Licences').click();
  await app.text(/^preact \d/).click();
  await app.text('Copyright (c) 2015-present Jason Miller').waitFor();
});
