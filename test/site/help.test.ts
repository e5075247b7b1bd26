import { expect, test } from 'vitest';
import { AppPage } from './app-page.js';
import { isWellMade } from './well-made.js';

test('each page of the help, and the help over the table, can be used by everyone', async () => {
  const app = await AppPage.open();
  const { page } = app;
  for (const name of ['checklist', 'trouble', 'words', 'steps']) {
    await page.evaluate((hash) => location.assign(hash), `#help/${name}`);
    await page.getByRole('heading', { level: 2 }).waitFor();
    if (name === 'trouble') await app.text('The timer does not answer').click();
    if (name === 'checklist') await page.getByRole('checkbox').first().check();
    await isWellMade(app, name);
  }
  await page.evaluate(() => location.assign('#program'));
  await app.trySimulated('F1Q');
  await app.button('What the values are').click();
  await page.getByRole('dialog', { name: 'What the values are' }).waitFor();
  await isWellMade(app, 'values over the table');
});

test('the key ? leads to the help and Back to where the pilot was', async () => {
  const app = await AppPage.open();
  const { page } = app;
  await app.trySimulated('F1B');
  await page.locator('main').focus();
  await page.keyboard.press('?');
  await page.getByRole('heading', { level: 1, name: 'Help' }).waitFor();
  await page.goBack();
  await app.table.waitFor();
  expect(new URL(page.url()).hash.replace('#program', '')).toBe('');
});
