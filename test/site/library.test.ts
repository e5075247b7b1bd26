import { expect, it } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { Keys } from './keys.js';
import { makeModel, makeProgram } from './library.js';
import { PHONE } from './page.js';

const open = async (app: AppPage, address: string): Promise<void> => {
  await app.page.evaluate((hash) => location.assign(hash), address);
};

it('what is typed about a setting at last is there after a reload, and what was deleted is gone', async () => {
  const app = await AppPage.open({ viewport: { width: 1280, height: 800 } });
  await open(app, '#library');
  await makeModel(app, 'Lancer 07');
  await makeProgram(app, 'fly-off, calm');
  const page = app.page.getByRole('article', { name: 'fly-off, calm' });
  const note = page.getByRole('textbox', { name: 'Note' });
  // At once: the field is not left.
  await note.fill('opens well, in wind too');
  await app.reload();
  await page.waitFor();
  await expect.poll(() => note.inputValue()).toBe('opens well, in wind too');
  const { hash } = new URL(app.page.url());
  await page.getByRole('button', { name: 'Delete' }).click();
  await app.says(en.removed({ what: '1\u00a0program' }));
  // At once: for ten seconds it could still be put back.
  await app.reload();
  await open(app, hash);
  await app.text(en.library.setting.gone).waitFor();
});

it('models are made with the keyboard alone', async () => {
  const app = await AppPage.open({ viewport: { width: 1280, height: 800 } });
  await open(app, '#library');
  const keys = new Keys(app.page);
  for (const name of ['First', 'Second']) {
    await app.button('New model…').waitFor();
    await keys.enter(/^New model…$/);
    await app.page.getByRole('dialog').waitFor();
    await keys.type(name);
    await keys.press('Enter');
    await app.page.getByRole('heading', { name, level: 1 }).waitFor();
    await app.page.evaluate(() => document.querySelector<HTMLElement>('main')?.focus());
    await open(app, '#library');
  }
});

it('on a phone on its side all that a setting is saved with is in sight', async () => {
  const app = await AppPage.simulated({ ...PHONE, viewport: { width: 844, height: 390 } });
  await app.page.keyboard.press('Control+k');
  await app.page.keyboard.type('save');
  await app.page.keyboard.press('Enter');
  const dialog = app.page.getByRole('dialog', { name: 'Save' });
  const bottoms = () =>
    dialog
      .locator('input, select, textarea, .buttons')
      .evaluateAll((all) =>
        all.map((each) => each.getBoundingClientRect()[each.matches('.buttons') ? 'top' : 'bottom']),
      );
  await expect.poll(async () => (await bottoms()).length).toBe(5);
  const [buttons = 0, ...fields] = (await bottoms()).reverse();
  expect(Math.max(...fields)).toBeLessThanOrEqual(buttons);
});

it('on a phone the library shows one page at a time, with a way back, and nothing is wider than the screen', async () => {
  const app = await AppPage.open(PHONE);
  const hasHeading = (name: string) => app.page.getByRole('heading', { level: 1, name, exact: true }).waitFor();
  await open(app, '#library');
  await hasHeading('Library');
  await makeModel(app, 'Lancer 07');
  await hasHeading('Lancer 07');
  await app.expectNoSidewaysScrolling();
  await makeProgram(app, 'calm');
  await hasHeading('calm');
  await app.expectNoSidewaysScrolling();
  await app.page.getByRole('link', { name: 'Lancer 07', exact: true }).click();
  await app.page.getByRole('link', { name: /^calm/ }).waitFor();
  await app.page.getByRole('link', { name: 'All models' }).click();
  await app.page.getByRole('link', { name: /^Lancer 07/ }).waitFor();
  await app.page.goBack();
  await app.page.getByRole('link', { name: /^calm/ }).waitFor();
});

it('names that are one word without end make nothing wider than a small phone', async () => {
  const app = await AppPage.open({ ...PHONE, viewport: { width: 360, height: 740 } });
  const { page } = app;
  const word = 'W'.repeat(60);
  await open(app, '#library');
  await makeModel(app, word);
  await makeProgram(app, word);
  const { hash } = new URL(page.url());
  const own = page.getByRole('article', { name: word });
  for (const [field, text] of [
    ['Note', word.repeat(3)],
    [en.library.setting.tags, `${word}, ${word.toLowerCase()}`],
  ] as const) {
    await own.getByRole('textbox', { name: field }).fill(text);
    await own.getByRole('textbox', { name: field }).blur();
  }
  const fits = async (): Promise<void> => {
    await app.expectNoSidewaysScrolling();
    const over = page.locator('dialog').evaluateAll((all) => all.map((each) => each.scrollWidth - each.clientWidth));
    expect(await over, 'a dialog scrolls to the side').not.toContainEqual(expect.toSatisfy((more) => more > 0));
  };
  await fits();
  await open(app, '#program');
  await app.resize({ width: 320, height: 640 });
  await page.locator('.kept').waitFor();
  await fits();
  await app.resize({ width: 360, height: 740 });
  for (const [task, shown] of [
    ['Share…', 'dialog .qr-code'],
    ['Print…', '.print-view .leaf-title'],
    ['Open', '.actions'],
    // With the setting that is open.
    ['Compare…', '.timeline-behind'],
  ] as const) {
    await open(app, hash);
    await own.getByRole('button', { name: task }).click();
    await page.locator(shown).filter({ visible: true }).first().waitFor();
    await fits();
    if (task === 'Share…') await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
  }
});
