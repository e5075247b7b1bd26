import { expect, test } from 'vitest';
import { decodeLink, encodeLink, LINK_MARK, type SharedSetting } from '../../src/program/index.js';
import { exampleMemories } from '../../src/simulator/index.js';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { pagesOf } from './pdf.js';

const [CALM] = exampleMemories('Q');
const WIND: SharedSetting = {
  name: 'wind',
  note: '',
  at: 1_795_000_000_000,
  tags: [],
  modelName: 'Magpie',
  program: {
    identity: { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 },
    memory: 1,
    times: (CALM?.times ?? []).map((time) => time + 5),
    positions: (CALM?.positions ?? []).map((row) => row.map((position) => position + 1)),
    idleThrottle: 30,
  },
};

/** The text of what the page prints, in the order of the page. */
async function printed(app: AppPage): Promise<string> {
  const pages = await pagesOf(await app.page.pdf({ preferCSSPageSize: true }));
  return pages.map(({ text }) => text).join(' ');
}

async function goToPrint(app: AppPage): Promise<void> {
  await app.page.evaluate(() => location.assign('#print'));
  await app.page.locator('.leaf').getByRole('row', { name: /^DT/ }).waitFor();
  await app.page.evaluate(() => document.fonts.ready);
}

async function goToProgram(app: AppPage): Promise<void> {
  await app.page.evaluate(() => location.assign('#program'));
  await app.table.waitFor();
}

test('values of one model over the timer of another keep their name, on paper, in a link and when saved', async () => {
  const app = await AppPage.open();
  await app.page.evaluate((to) => void location.assign(to), LINK_MARK + encodeLink(WIND));
  await app.button(en.share.received.keep).click();
  await app.page.waitForURL(/#library\//);
  await app.page.evaluate(() => location.assign('#program'));
  await app.trySimulated('F1Q');
  await app.button(en.library.save.open).click();
  const dialog = app.page.getByRole('dialog');
  await dialog.getByRole('textbox', { name: en.library.save.name({ of: 'program' }) }).fill('calm');
  await dialog.getByRole('combobox', { name: 'Model' }).selectOption(en.library.models.make);
  await dialog.getByRole('textbox', { name: en.library.save.name({ of: 'model' }) }).fill('Lancer');
  await dialog.getByRole('button', { name: 'Save', exact: true }).click();
  await app.text('calm of Lancer: saved').waitFor();
  await app.button('Model Lancer: say which model it is').waitFor();
  expect(await app.text(/Which model is it/).count(), 'nobody is asked whose timer it is').toBe(0);

  await app.type('Function 4, S2', '77');
  await goToPrint(app);
  await expect.poll(() => printed(app)).toMatch(/77 was 52/);
  const changed = await printed(app);
  expect(changed).toMatch(/Lancer calm, changed/);
  expect(changed).toMatch(/1 change\. Marked fields differ from what was last read/);
  expect(changed).not.toContain('As in the timer');
  await goToProgram(app);
  await app.button('Undo all').click();
  await goToPrint(app);
  await expect.poll(() => printed(app)).toMatch(/Lancer calm .*As in the timer, read/);

  await app.goTo('Library');
  await app.page.getByRole('link', { name: /^Magpie/ }).click();
  await app.page.getByRole('link', { name: /^wind/ }).click();
  await app.button(en.open).click();
  await app.text('wind of Magpie: saved').waitFor();
  await goToPrint(app);
  await expect
    .poll(() => printed(app))
    .toMatch(/Magpie wind .*These are values of Magpie, but this timer looks like that of Lancer/);
  expect(await printed(app)).not.toContain('As in the timer');
  await goToProgram(app);
  await app.button('Share…').click();
  const link = await app.page.getByRole('textbox', { name: 'Link' }).inputValue();
  await app.button('Close').click();
  expect(decodeLink(link)).toMatchObject({ modelName: 'Magpie', name: 'wind', program: { memory: 1 } });

  await app.type('DT time', '2:00');
  await app.button('Save over wind of Magpie').click();
  await app.button('Take back the save of wind').click();
  await app.text('wind of Magpie: 1 change not saved').waitFor();
  await app.button('Undo all').click();
  // What the timer holds is what was saved of it.
  await app.text('calm of Lancer: saved').waitFor();
  expect(await app.button(/Magpie/).count()).toBe(0);
});
