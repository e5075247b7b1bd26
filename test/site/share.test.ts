import { expect, inject, test } from 'vitest';
import { decodeLink, encodeLink, LIMITS, LINK_MARK } from '../../src/program/index.js';
import { SETTING } from '../program/library-examples.js';
import { en } from '../tools/en.js';
import { AppPage, edgesOf } from './app-page.js';
import { saveFirst } from './library.js';
import { PHONE } from './page.js';
import { textOfCode } from './qr.js';
import { showTheme, THEMES } from './themes.js';

const { program, name, at, tags } = SETTING;
const SHARED = { name, note: 'Turns left after 12 s. '.repeat(20), at, tags, program, modelName: 'Lancer 07' };
const HASH = LINK_MARK + encodeLink(SHARED);
const arrive = (app: AppPage, hash: string): Promise<void> => app.page.evaluate((to) => void location.assign(to), hash);

test('a setting that is shared by link can be kept on another device, after one question', async () => {
  const pilot = await AppPage.simulated();
  await pilot.type('DT time', '4:00');
  await saveFirst(pilot, 'windy', 'Lancer 07');
  await pilot.goTo('Library');
  await pilot.page.getByRole('link', { name: /^Lancer 07/ }).click();
  await pilot.page.getByRole('link', { name: /windy/ }).click();
  await pilot.button('Share…').click();
  const link = await pilot.field('Link').inputValue();
  expect(link.startsWith(`${inject('site')}#s=`)).toBe(true);

  const friend = await AppPage.open();
  await friend.page.goto('about:blank');
  await friend.page.goto(link);
  const dialog = friend.page.getByRole('dialog', { name: en.share.received.title });
  await dialog.getByText('windy', { exact: true }).waitFor();
  await expect.poll(() => dialog.getByRole('row', { name: /^DT/ }).innerText()).toContain('4:00');
  await friend.reload();
  await dialog.getByRole('button', { name: en.share.received.keep }).click();
  await friend.page.getByRole('heading', { name: 'windy' }).waitFor();
  await friend.reload();
  await friend.page.getByRole('heading', { name: 'windy' }).waitFor();
  await expect.poll(() => dialog.count()).toBe(0);
  await friend.page.goBack();
  await expect.poll(() => dialog.count(), { message: 'the question does not come again on the way back' }).toBe(0);
});

test('the QR code of a setting can be read from the screen, in every theme', async () => {
  for (const size of [{}, PHONE]) {
    const app = await AppPage.open(size);
    await arrive(app, HASH);
    await app.button(en.share.received.keep).click();
    await app.button('Share…').click();
    await app.page.getByRole('img', { name: 'QR code of “calm morning”' }).waitFor();
    for (const theme of ['light', 'dark', 'sun', 'forced']) {
      if (theme === 'forced') await app.page.emulateMedia({ forcedColors: 'active', colorScheme: 'dark' });
      else await showTheme(app, theme);
      const link = await textOfCode(app.page, await app.page.locator('.qr-code').screenshot());
      expect(decodeLink(link).note).toMatch(/^Turns left after 12 s\./);
    }
  }
});

const NAMES = [name, 'WETTBEWERBSFLIEGER '.repeat(4).slice(0, LIMITS.name)];
test.each(NAMES)('code and link of “%s” are in sight at once, on every size and in every theme', async (name) => {
  const app = await AppPage.open();
  await arrive(app, LINK_MARK + encodeLink({ ...SHARED, name, note: '' }));
  await app.button(en.share.received.keep).click();
  await app.button('Share…').click();
  await app.page.getByRole('img', { name: `QR code of “${name}”` }).waitFor();
  for (const [width, height] of [
    [390, 844],
    [360, 740],
    [844, 390],
    [820, 1180],
    [1280, 800],
    [1366, 650],
    [1440, 900],
  ] as const) {
    await app.resize({ width, height });
    for (const theme of THEMES) {
      await showTheme(app, theme);
      const [code, link, copy, close] = await Promise.all(
        [
          app.page.locator('.qr-code svg'),
          app.field('Link'),
          app.button('Copy link'),
          app.page.getByRole('dialog').getByRole('button', { name: 'Close' }),
        ].map(edgesOf),
      );
      const where = `${width} x ${height}, ${theme}`;
      for (const part of [code, link, copy]) expect(part?.bottom, where).toBeLessThanOrEqual(close?.top ?? 0);
      expect(Math.min(code?.top ?? 0, link?.top ?? 0), where).toBeGreaterThan(0);
      expect(close?.bottom, where).toBeLessThanOrEqual(height);
      const dialog = await edgesOf(app.page.getByRole('dialog'));
      if (width < 600) expect(dialog.width, `${where}: a phone has no room to give away`).toBeGreaterThan(width - 24);
      expect(code?.width, `${where}: a camera needs some pixels for each square`).toBeGreaterThan(159);
    }
  }
});
