import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';

test('the help for a port that is taken leads to a page with all steps', async () => {
  const app = await AppPage.open({ bench: { granted: true } });
  await app.bench((bench) => bench.setBusy(true));
  await app.button('Connect').click();
  await app.says(en.link.refused);
  await app.page.getByText(en.help.title).first().click();
  const all = app.page.getByRole('link', { name: en.help.page }).first();
  const page = await app.page.request.get(new URL((await all.getAttribute('href')) ?? '', app.page.url()).href);
  expect(await page.text()).toContain('brltty');
});

test('times with exchanged bytes bring a question, are shown, and remembered', async () => {
  const app = await AppPage.connected({ bench: { quirks: { bigEndianTimes: true } } });
  await app.says('The times of this timer fall from row to row.');
  await app.button(en.byteOrder.exchange).click();
  await expect.poll(() => app.valueOf('DT time')).toBe('3:00');
  await app.showAbout();
  await app.text(en.aboutTimer.quirkNames['times-big-endian']).waitFor();
  const assumed = app.page.getByRole('checkbox', { name: en.aboutTimer.assumptions.bigEndianTimes });
  await expect.poll(() => assumed.isChecked()).toBe(true);

  await app.goTo('Program');
  await app.reload();
  await app.connect();
  await expect.poll(() => app.valueOf('DT time')).toBe('3:00');
  await expect.poll(() => app.text('The times of this timer fall from row to row.').count()).toBe(0);
});
