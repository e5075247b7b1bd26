import { expect, test } from 'vitest';
import { AppPage } from './app-page.js';

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
