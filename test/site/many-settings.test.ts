import { expect, it } from 'vitest';
import { manyRecords } from '../app/library/many.js';
import { AppPage } from './app-page.js';
import { fillLibrary } from './library.js';

it('a library of 2,000 settings lays out only what is near, and its search stays', async () => {
  const app = await AppPage.open();
  await fillLibrary(app, manyRecords({ models: 40, settings: 2000, flights: 0 }));
  await app.page.evaluate(() => location.assign('#library'));
  await app.reload();
  const rows = app.page.locator('.library-settings').first().locator('> li');
  await app.page.getByRole('searchbox').fill('fly-off séries');
  await expect.poll(() => rows.count()).toBeGreaterThan(400);
  const inRow = rows.last().getByRole('link');
  expect(await inRow.evaluate((link) => link.checkVisibility({ contentVisibilityAuto: true }))).toBe(false);
  await rows.nth(200).scrollIntoViewIfNeeded();
  await rows.nth(200).getByRole('link').click();
  await app.page.locator('.setting-page').waitFor();
  await app.page.goBack();
  await expect
    .poll(() => app.page.getByRole('searchbox').inputValue(), { message: 'the search stays' })
    .toBe('fly-off séries');
});
