import { expect, inject, test } from 'vitest';
import { LANGUAGES, languageName } from '../../src/app/messages/first.js';
import { en } from '../tools/en.js';
import { sentencesIn } from '../tools/spoken.js';
import { AppPage } from './app-page.js';
import { newPage } from './page.js';

type Said = Awaited<ReturnType<typeof sentencesIn>>;

/** Looks at the start of the page. */
async function startIn(app: AppPage, language: string, said: Said): Promise<void> {
  const { page } = app;
  await page.locator(`html[lang=${language}]`).waitFor();
  await page.getByRole('heading', { name: said.start.title }).waitFor();
  const manifest = language === 'en' ? './manifest.webmanifest' : `./manifest.${language}.webmanifest`;
  expect(await page.locator('link[rel=manifest]').getAttribute('href')).toBe(manifest);
  expect(await page.title()).toBe(said.name);
  await page.getByRole('combobox', { name: said.label.language }).waitFor();
}

/** Goes to a view by the words of a language. */
async function goTo(app: AppPage, said: Said, view: 'program' | 'library' | 'settings'): Promise<void> {
  await app.page.getByRole('link', { name: said.views.names[view], exact: true }).click();
  await app.page.locator(`.${view}-view`).waitFor();
}

/** Chooses a language in the settings, whose words are now those of another one. */
async function choose(app: AppPage, said: Said, language: string): Promise<void> {
  await app.page.getByRole('combobox', { name: said.label.language }).selectOption(languageName(language));
  await app.page.locator(`html[lang=${language}]`).waitFor();
}

test.for([
  ['de', 'de-AT'],
  ['uk', 'uk-UA'],
] as const)('a pilot whose browser speaks %s does everything in it', async ([language, locale]) => {
  const said = await sentencesIn(language);
  const { program, write } = said;
  const app = await AppPage.open({ locale });
  const { page } = app;
  await startIn(app, language, said);

  await app.button(said.start.simulated({ name: said.classNames.Q })).click();
  await app.isReady();
  const slot = said.slotName({ slot: 4, kind: 'function' });
  const time = program.timeOf({ slot });
  const servo = said.servoName({ number: 2 });
  const position = program.positionOf({ slot, servo });
  const dt = program.timeOf({ slot: said.slotName({ slot: 10, kind: 'dt' }) });
  const before = await app.valueOf(time);
  expect(before, 'a comma is its decimal sign').toMatch(/^\d+,\d\d$/);
  await app.type(time, '9,5');
  await expect.poll(() => app.valueOf(time)).toBe('9,50');
  await app.type(time, '9.6');
  await expect.poll(() => app.valueOf(time)).toBe('9,60');
  for (const typed of ['2,58', '2.58']) {
    await app.type(dt, typed);
    const question = page.getByRole('group', { name: said.times.meaning({ field: dt }) });
    await question.getByRole('button').first().click();
    await expect.poll(() => app.valueOf(dt), { message: typed }).toBe('2:58');
  }
  const change = page.getByText(program.changes({ count: 2 }), { exact: true });
  await change.waitFor();
  await app.type(position, '71');
  const what = program.positionOf({ slot: said.within.slot({ slot: 4, kind: 'function' }), servo });
  await app.button(said.edits.undo({ step: said.edits.steps.change({ what }) })).click();
  await change.waitFor();

  await app.button(program.write({ count: 2 })).click();
  const dialog = page.getByRole('dialog', { name: write.title });
  // Without zeros at their end.
  const figure = (text: string) => said.times.figure({ text: text.replace(/0$/, ''), unit: said.times.units.s });
  const cellsOf = (name: string) => dialog.getByRole('row', { name }).getByRole('cell').allInnerTexts();
  await expect.poll(() => cellsOf(slot)).toEqual([figure(before), figure('9,60')]);
  await dialog.getByRole('checkbox', { name: write.safety }).check();
  await dialog.getByRole('button', { name: write.start({ count: 2 }) }).click();
  await dialog.getByRole('alert').getByText(write.verified.title).waitFor();
  await dialog.getByRole('button', { name: said.close }).click();

  await app.button(said.library.save.open).click();
  const save = page.getByRole('dialog');
  for (const [of, name] of [
    ['program', 'Пором'],
    ['model', 'Čáp'],
  ] as const)
    await save.getByRole('textbox', { name: said.library.save.name({ of }) }).fill(name);
  await save.getByRole('button', { name: said.save, exact: true }).click();
  await save.waitFor({ state: 'hidden' });
  await goTo(app, said, 'library');
  await page.getByRole('link', { name: 'Пором' }).waitFor();
  await page.evaluate(() => location.assign('#print'));
  const sheet = page.locator('.leaf');
  await sheet.getByRole('rowheader', { name: slot }).waitFor();
  await sheet.getByText(/^9,6/).waitFor();
});

test('the language changes while something is not finished, and nothing is lost', async () => {
  const said = await sentencesIn('de');
  const app = await AppPage.open({ locale: 'de-AT' });
  const { page } = app;
  await app.button(said.start.simulated({ name: said.classNames.Q })).click();
  await app.isReady();
  const names = ({ slotName, servoName, program }: Said) => {
    const slot = slotName({ slot: 4, kind: 'function' });
    const [first, second] = [1, 2].map((number) => program.positionOf({ slot, servo: servoName({ number }) }));
    return { time: program.timeOf({ slot }), first: first ?? '', second: second ?? '' };
  };
  const own = names(said);
  await app.type(own.time, '9,5');
  await app.type(own.first, '71');
  await app.type(own.second, '7x');
  const expectIn = async (spoken: Said, time: string): Promise<void> => {
    await goTo(app, spoken, 'program');
    const of = names(spoken);
    const seen = () => Promise.all([of.time, of.first, of.second].map((name) => app.valueOf(name)));
    await expect.poll(seen).toEqual([time, '71', '7x']);
    await page.getByText(spoken.unreadable['not-a-whole-number']).first().waitFor();
    await goTo(app, spoken, 'settings');
  };
  await goTo(app, said, 'settings');
  await choose(app, said, 'en');
  await expectIn(en, '9.50');
  await choose(app, en, 'de');
  await expectIn(said, '9,50');

  await choose(app, said, 'en');
  await page.evaluate(() => location.assign('#'));
  await app.reload();
  await page.locator('html[lang=en]').waitFor();
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
  await page.context().setOffline(true);
  await goTo(app, en, 'settings');
  let spoken: Said = en;
  for (const language of LANGUAGES.filter((each) => each !== 'en')) {
    await choose(app, spoken, language);
    spoken = await sentencesIn(language);
    await page.getByRole('heading', { name: spoken.views.names.settings, exact: true }).waitFor();
  }
});

test('the browser changes its language while the page is still loaded', async () => {
  // A worker would answer in place of the host.
  const page = await newPage({ locale: 'fr-FR', serviceWorkers: 'block' }, []);
  let answer = () => {};
  const changed = new Promise<void>((resolve) => {
    answer = resolve;
  });
  await page.route('**/assets/open-page-*.js', async (route) => {
    await changed;
    await route.continue();
  });
  await page.goto(inject('site'), { waitUntil: 'commit' });
  await page.locator('html[lang=fr]').waitFor();
  await page.evaluate(() => {
    localStorage.setItem('sidus-timer/language', '"de"');
    window.dispatchEvent(new Event('languagechange'));
  });
  answer();
  await startIn(new AppPage(page), 'de', await sentencesIn('de'));
});

test('a browser with a language that the page has not gets English', async () => {
  const app = await AppPage.open({ locale: 'ja-JP' });
  await startIn(app, 'en', en);
});
