import { describe, expect, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { AppPage } from './app-page.js';

describe('the port is taken', () => {
  test('by another program: the page says what to do, with a command to copy and a link to all steps', async () => {
    const app = await AppPage.open({
      bench: { granted: true },
      permissions: ['clipboard-read', 'clipboard-write'],
      // The steps depend on the system that the browser names.
      before: () =>
        Object.defineProperty(navigator, 'userAgentData', {
          value: { platform: 'Linux', brands: [] },
          configurable: true,
        }),
    });
    await app.bench((bench) => bench.setBusy(true));
    await app.button('Connect').click();
    await app.says(en.link.refused);
    await app.page.getByText(en.help.title).first().click();
    const linux = app.page.getByRole('listitem').filter({ hasText: en.help.steps.linux });
    await linux.getByRole('button', { name: en.copy }).click();
    await linux.getByText(en.copied).waitFor();
    expect(await app.page.evaluate(() => navigator.clipboard.readText())).toBe('sudo usermod -a -G dialout $USER');
    const all = app.page.getByRole('link', { name: en.help.page }).first();
    const page = await app.page.request.get(new URL((await all.getAttribute('href')) ?? '', app.page.url()).href);
    expect(await page.text()).toContain('brltty');
  });
});

describe('about this timer', () => {
  test('times with exchanged bytes bring a question, are shown, and remembered', async () => {
    const app = await AppPage.open({ bench: { granted: true, quirks: { bigEndianTimes: true } } });
    await app.connect();
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
});
