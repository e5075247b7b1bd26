import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { chooseFile, downloadedBy, saveFirst } from './library.js';

test('after one visit a whole day on the field needs no network, from Connect to a setting for a friend', async () => {
  const app = await AppPage.open({ acceptDownloads: true });
  const { page } = app;
  await app.text(en.start.readyOffline).waitFor();
  await page.context().setOffline(true);
  await app.reload();
  await app.text(en.start.readyOffline).waitFor();
  expect(await page.evaluate(() => navigator.onLine)).toBe(false);

  await app.trySimulated('F1Q');
  await app.type('DT time', '4:00');
  await app.write();
  await app.result('Verified.');
  await app.close();

  await saveFirst(app, 'windy', 'Lancer 07');
  await app.type('Function 4, S2', '77');
  await app.goTo('Library');
  await page.getByRole('link', { name: /^Lancer 07/ }).click();
  await page.getByRole('link', { name: /^windy/ }).click();
  const setting = page.getByRole('article', { name: 'windy' });

  await setting.getByRole('button', { name: 'Compare…' }).click();
  await app.text('1 value differs.').waitFor();
  await page.goBack();

  await setting.getByRole('button', { name: 'Share…' }).click();
  await page.getByRole('img', { name: 'QR code of “windy”' }).waitFor();
  const link = app.field('Link');
  await expect.poll(() => link.inputValue()).toMatch(/#s=[\w-]{100,}$/);
  const hash = new URL(await link.inputValue()).hash;
  await app.button('Close').click();

  const { text: file } = await downloadedBy(app, () => setting.getByRole('button', { name: 'Export…' }).click());

  await setting.getByRole('button', { name: 'Print…' }).click();
  await page.locator('.print-sheets').getByText('windy').first().waitFor();

  // A friend sends the same setting with his changes, as a file and as a link.
  await page.evaluate(() => location.assign('#library'));
  await chooseFile(app, 'friend.sidus.json', file.replaceAll('"windy"', '"windy, by a friend"'));
  await page.getByRole('heading', { name: 'Import friend.sidus.json' }).waitFor();
  await page.getByRole('dialog').getByText(en.files.import.ways.both, { exact: true }).click();
  await app.button(/^Import \d+$/).click();
  await app.text(/^Imported from “friend\.sidus\.json”: /).waitFor();
  await page.evaluate((to) => location.assign(to), hash);
  await page.getByRole('dialog', { name: en.share.received.title }).getByText('windy', { exact: true }).waitFor();
  await app.button('Do not keep').click();

  await page.evaluate(() => location.assign('#help/checklist'));
  await app.text(/^M1 flies next, DT\s4:00\smin, read /).waitFor();
  for (const name of ['Trouble', 'Values', 'First steps']) {
    await page.getByRole('link', { name, exact: true }).click();
    await page.getByRole('heading', { level: 2, name }).waitFor();
  }
  await page.goBack();
  await page.getByRole('heading', { level: 2, name: 'Values' }).waitFor();

  await app.goTo('Settings');
  await app.text('The whole page is on this device').waitFor();
  const [licences] = await Promise.all([
    page.context().waitForEvent('page'),
    page.getByRole('link', { name: 'Licences' }).click(),
  ]);
  await licences.getByText('Copyright (c) 2015-present Jason Miller').waitFor();
});
