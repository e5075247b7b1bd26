import type { Locator } from 'playwright';
import { expect, test } from 'vitest';
import { type LibraryFile, parseLibraryFile } from '../../src/program/index.js';
import { exampleMemories } from '../../src/simulator/index.js';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { chooseFile, downloadedBy } from './library.js';

/*
 * A pilot's season, only through the screen: three models, twelve settings, thirty flights. Then the device is lost,
 * and another device gets everything back from one file.
 */

/** What the timer of a model holds before the season: trimmed, so that the page can recognise the model. */
function memoriesOf(model: number) {
  return exampleMemories('Q').map(({ times, positions }, memory) => ({
    times: times.map((time, slot) => time + (slot > 0 && slot < 10 ? 5 * model + memory : 0)),
    positions: positions.map((row, servo) =>
      row.map((position, slot) => Math.min(130, position + 1 + ((model * (slot + 3) + 7 * servo * model) % 31))),
    ),
  }));
}
type Memories = ReturnType<typeof memoriesOf>;

/** The season of one model: its name, and what the pilot types. */
interface Kept {
  readonly name: string;
  readonly dt: string;
  readonly tags: string;
  readonly note: string;
}
const LANCER: readonly Kept[] = [
  { name: 'calm', dt: '3:10', tags: 'calm, round', note: 'Turns left after 12 s.' },
  { name: 'windy', dt: '3:20', tags: 'windy', note: 'Bunts a little: 2 steps less.' },
  { name: 'fly-off', dt: '6:00', tags: 'fly-off', note: 'Hűvös reggel, 6 min.' },
  { name: 'morning', dt: '4:00', tags: '', note: '' },
  { name: 'new propeller', dt: '3:30', tags: 'test', note: 'From 5 November on.\nSecond line.' },
];
const VEGA: readonly Kept[] = [
  { name: 'first trim', dt: '2:30', tags: 'trim', note: '' },
  { name: 'calm', dt: '3:05', tags: 'calm', note: 'As Lancer, but slower.' },
  { name: 'thermal', dt: '3:40', tags: 'thermal, noon', note: '' },
  { name: 'fly-off', dt: '8:00', tags: 'fly-off', note: '8 min.' },
];
const RIDGE: readonly Pick<Kept, 'name' | 'tags' | 'note'>[] = [
  { name: 'slope, light', tags: 'light', note: 'By hand, from the notebook.' },
  { name: 'slope, strong', tags: 'strong', note: '' },
  { name: 'slope, evening', tags: '', note: 'Sun low: start early.' },
];
const FLIGHTS = { lancer: 13, vega: 11, ridge: 6 };

/** A device of the pilot, with its own bench. */
class Device {
  readonly app: AppPage;

  constructor(app: AppPage) {
    this.app = app;
  }

  static async open(): Promise<Device> {
    const app = await AppPage.open({
      bench: {},
      isMoving: true,
      acceptDownloads: true,
      viewport: { width: 1280, height: 800 },
    });
    return new Device(app);
  }

  /** Puts the timer of another model under the infrared head. */
  async hold(memories: Memories): Promise<void> {
    await this.app.page.evaluate((held) => {
      const { core } = window.workbench.adapter.timer;
      core.memories.splice(0, core.memories.length, ...held);
      core.memory = 0;
    }, memories);
  }

  /** What the timer holds now. */
  held(): Promise<Memories> {
    return this.app.bench(({ adapter }) => adapter.timer.core.memories) as Promise<Memories>;
  }

  async disconnect(): Promise<void> {
    await this.app.button('Disconnect').first().click();
    await this.app.button('Connect').waitFor();
  }

  /** Goes to a model or a setting through the list, as a pilot does. */
  async goTo(model: string, setting?: string): Promise<Locator> {
    const { app } = this;
    await app.page.evaluate(() => location.assign('#library'));
    await app.page
      .getByRole('region', { name: en.library.models.title })
      .getByRole('link', { name: new RegExp(`^${model}`) })
      .click();
    const column = app.page.getByRole('region', { name: model, exact: true });
    await column.waitFor();
    if (setting === undefined) return column;
    await column
      .locator('.library-settings')
      .getByRole('link', { name: new RegExp(`^${setting}`) })
      .first()
      .click();
    const page = app.page.getByRole('article', { name: setting, exact: true });
    await page.waitFor();
    return page;
  }

  /** Saves what is on the screen under a name. */
  async saveAs(name: string, model: string, note: string): Promise<void> {
    const { app } = this;
    const first = app.button(en.library.save.open);
    await first.or(app.button(en.library.save.asNew)).first().click();
    const dialog = app.page.getByRole('dialog', { name: 'Save' });
    await dialog.getByRole('textbox', { name: en.library.save.name({ of: 'program' }) }).fill(name);
    await dialog.getByRole('combobox', { name: 'Model' }).selectOption({ label: model });
    await dialog.getByRole('textbox', { name: 'Note' }).fill(note);
    await dialog.getByRole('button', { name: 'Save', exact: true }).click();
    await dialog.waitFor({ state: 'hidden' });
  }

  /** Tags are given in the library. */
  async tag(model: string, settings: readonly Pick<Kept, 'name' | 'tags'>[]): Promise<void> {
    for (const { name, tags } of settings) {
      const page = await this.goTo(model, name);
      await page.getByRole('textbox', { name: en.library.setting.tags }).fill(tags);
    }
  }

  async writeAndLog(): Promise<void> {
    await this.app.write();
    await this.app.result('Verified.');
    await this.app.dialog.getByRole('button', { name: 'Flying this' }).click();
    await this.app.dialog.getByText(/^Flight\slogged\s\d\d:\d\d/).waitFor();
  }

  get form(): Locator {
    return this.app.page.getByRole('dialog', { name: 'Flight' });
  }

  /** Fills in the open flight, then flies again, this many flights in all. */
  async fly(count: number, firstResult: number, place: string): Promise<void> {
    const { form } = this;
    for (let at = 0; at < count; at++) {
      const result = form.getByRole('textbox', { name: 'Result' });
      await expect.poll(() => result.inputValue()).toBe('');
      await result.fill(String(firstResult + at));
      if (at === 0) {
        await form.getByRole('button', { name: '1', exact: true }).click();
        await form.getByRole('button', { name: 'Wind: more' }).click();
        await form.getByRole('textbox', { name: 'Temperature °C' }).fill('-2,5');
        await form.getByRole('textbox', { name: 'Note' }).fill(`First of ${count} at ${place}`);
        await form.getByText(en.flights.form.when).click();
        await form.getByRole('combobox', { name: 'Place' }).fill(place);
      }
      const isLast = at === count - 1;
      await form.getByRole('button', { name: isLast ? 'Done' : en.flights.flying.again }).click();
    }
    await form.waitFor({ state: 'hidden' });
  }

  /** Imports a file, after looking at what it shows before. */
  async takeFile(text: string): Promise<void> {
    const { page } = this.app;
    await page.evaluate(() => location.assign('#library'));
    await this.app.text(en.library.empty.title).waitFor();
    await chooseFile(this.app, 'from the lost one.sidus.json', text);
    await this.app.text('It holds 3 models, 12 programs, 30 flights.').waitFor();
    await this.app.button('Import 45').click();
    await this.app.text(/^Imported from .*: 3\smodels, 12\sprograms, 30\sflights\.$/).waitFor();
  }

  /** What the pilot sees: models and settings, and what was typed about them. */
  async showsTheSeason(): Promise<void> {
    const { page } = this.app;
    const names = async (list: string) => (await page.locator(`${list} b`).allInnerTexts()).sort();
    await page.evaluate(() => location.assign('#library'));
    const models = '.library-list:not(.library-settings, .library-more .library-list)';
    await expect.poll(() => names(models)).toEqual(['Lancer 07', 'Ridge 3', 'Vega 12']);
    const about = await this.goTo('Lancer 07');
    await expect
      .poll(() => names('.library-settings'))
      .toEqual(['calm', 'fly-off', 'morning', 'new propeller', 'windy']);
    await expect
      .poll(() => page.locator('.model-page').getByRole('textbox', { name: 'Note' }).inputValue())
      .toBe('Wing from 2019, 412 g.');
    await about.getByText(`${FLIGHTS.lancer} flights`).first().waitFor();
    const flyOff = await this.goTo('Vega 12', 'fly-off');
    await flyOff.getByText('8:00 min').first().waitFor();
    await expect
      .poll(() => flyOff.getByRole('textbox', { name: en.library.setting.tags }).inputValue())
      .toBe('fly-off');
    await page.evaluate(() => location.assign('#library/flights'));
    await this.app.text('30 flights').first().waitFor();
  }

  /** Everything in one file, from the downloads. */
  async exportAll(): Promise<string> {
    const { app } = this;
    await app.page.evaluate(() => location.assign('#library'));
    return (await downloadedBy(app, () => app.button('Export all…').click())).text;
  }
}

/** What a file contains of the season, as the pilot has typed it. */
function seasonOf({ library }: LibraryFile) {
  const settings = library.settings.map(({ name, tags, note, program }) => {
    const typed = { name, tags: tags.join(', '), note };
    const { timerClass, functions } = program.identity;
    const dt = (program.times[functions] as number) / 100;
    const text = `${Math.floor(dt / 60)}:${String(dt % 60).padStart(2, '0')}`;
    return timerClass === 'E' ? typed : { ...typed, dt: text };
  });
  const results = (at: string): (number | null)[] =>
    library.flights
      .filter(({ place }) => place === at)
      .map(({ result }) => result)
      .sort((a, b) => (a ?? 0) - (b ?? 0));
  return {
    models: library.models.map(({ name }) => name),
    settings,
    flights: { Gyula: results('Gyula'), Salonta: results('Salonta'), Turda: results('Turda') },
  };
}

function upFrom(first: number, count: number): number[] {
  return Array.from({ length: count }, (_, at) => first + at);
}

test('a season of three models is flown, and a lost device comes back on another one from one file', async () => {
  const first = await Device.open();
  const { app } = first;
  const { page } = app;

  // Lancer 07: read from its timer.
  await first.hold(memoriesOf(1));
  await app.connect();
  await app.button(en.recognition.which).click();
  await page.getByRole('dialog').getByRole('textbox', { name: 'Name' }).fill('Lancer 07');
  await app.button(en.whichModel.recognition.dialog.keep).click();
  await app.button('Model Lancer 07: say which model it is').waitFor();
  await app.goTo('Memories');
  for (const [memory, name] of [
    ['M1', 'calm'],
    ['M2', 'fly-off'],
  ] as const) {
    await page.getByRole('textbox', { name: `Name of ${memory}` }).fill(name);
    await page.keyboard.press('Enter');
  }
  await app.goTo('Program');
  for (const { name, dt, note } of LANCER) {
    await app.type('DT time', dt);
    await first.saveAs(name, 'Lancer 07', note);
  }
  await first.writeAndLog();
  await app.button('Fill in').click();
  await first.fly(FLIGHTS.lancer, 170, 'Gyula');
  await first.disconnect();

  // Filled in at home.
  const about = await first.goTo('Lancer 07');
  await page.locator('.model-page').getByRole('textbox', { name: 'Note' }).fill('Wing from 2019, 412 g.');
  await about.getByRole('heading', { name: 'Backups' }).waitFor();
  await first.tag('Lancer 07', LANCER);

  // Vega 12: another timer at the same adapter, with its settings and flights.
  const lancer = await first.held();
  await first.hold(memoriesOf(2));
  await page.evaluate(() => location.assign('#program'));
  await app.connect();
  await app.text(en.whichModel.recognition.unknown).waitFor();
  await app.button('Choose…').click();
  await page.getByRole('dialog').getByRole('textbox', { name: 'Name' }).fill('Vega 12');
  await app.button(en.whichModel.recognition.dialog.keep).click();
  for (const { name, dt, note } of VEGA) {
    await app.type('DT time', dt);
    await first.saveAs(name, 'Vega 12', note);
  }
  await first.writeAndLog();
  await app.button('Fill in').click();
  await first.fly(FLIGHTS.vega, 200, 'Salonta');
  await first.disconnect();
  await first.tag('Vega 12', VEGA);

  // Ridge 3: typed by hand; its timer comes later.
  await page.evaluate(() => location.assign('#library'));
  await app.button(en.library.models.make).click();
  const make = page.getByRole('dialog', { name: 'New model' });
  await make.getByRole('textbox', { name: 'Name' }).fill('Ridge 3');
  await make.getByText('F1E', { exact: true }).click();
  await app.button(en.save).click();
  for (const { name, note } of RIDGE) {
    await (await first.goTo('Ridge 3')).getByRole('button', { name: en.newProgram.title }).click();
    await page.getByRole('textbox', { name: en.library.save.name({ of: 'program' }) }).fill(name);
    await app.button(en.newProgram.make).click();
    await page.getByRole('article', { name, exact: true }).getByRole('textbox', { name: 'Note' }).fill(note);
  }
  await first.tag('Ridge 3', RIDGE);
  await page.evaluate(() => location.assign('#program'));
  await app.button(en.header.closeProgram).click();
  await app.trySimulated('F1E');
  await app.button('Choose…').click();
  await page.getByRole('dialog').getByRole('button', { name: 'Ridge 3' }).click();
  const light = await first.goTo('Ridge 3', 'slope, light');
  await light.getByRole('button', { name: en.open }).click();
  await app.table.waitFor();
  await app.type('Function 2, S1', '71');
  await app.button('Save over slope, light of Ridge 3').click();
  await app.button(/^Save over/).waitFor({ state: 'hidden' });
  await first.writeAndLog();
  await app.button('Fill in').click();
  await first.fly(FLIGHTS.ridge, 90, 'Turda');
  await first.disconnect();

  // Lancer comes back, and is recognised. Connect would come back to the simulated timer of the Ridge.
  await app.button(en.header.closeProgram).click();
  await first.hold(lancer);
  await app.connect();
  await app.text(/^This is Lancer 07, as seen /).waitFor();
  await first.disconnect();

  const lost = await first.exportAll();
  const before = parseLibraryFile(lost);
  expect(seasonOf(before)).toEqual({
    models: ['Lancer 07', 'Ridge 3', 'Vega 12'],
    // The last saved one first.
    settings: [RIDGE[0], RIDGE[2], RIDGE[1], ...[...VEGA].reverse(), ...[...LANCER].reverse()],
    flights: { Gyula: upFrom(170, 13), Salonta: upFrom(200, 11), Turda: upFrom(90, 6) },
  });
  expect(before.ignored).toEqual([]);
  expect(before.library.flights.find(({ note }) => note === 'First of 13 at Gyula')).toMatchObject({
    model: before.library.models[0]?.id,
    modelName: 'Lancer 07',
    settingName: 'new propeller',
    round: '1',
    wind: 2,
    temperature: -2.5,
    result: 170,
  });
  await page.close();

  // Another device, with nothing on it but this page.
  const second = await Device.open();
  await second.takeFile(lost);
  await second.app.reload();
  const after = parseLibraryFile(await second.exportAll());
  expect(after.library).toEqual(before.library);
  const factsOf = ({ library, facts }: LibraryFile) =>
    [...library.models, ...library.settings, ...library.flights].map((entry) => facts.get(entry));
  expect(factsOf(after), 'the file also carries what the timers were seen to hold').toEqual(factsOf(before));
  await second.showsTheSeason();

  // That device recognises the timer of Lancer, too, and loads another of its settings.
  await second.hold(lancer);
  await second.app.page.evaluate(() => location.assign('#program'));
  await second.app.connect();
  await second.app.text(/^This is Lancer 07, as seen /).waitFor();
  await second.app.button('OK').click();
  const windy = await second.goTo('Lancer 07', 'windy');
  await windy.getByRole('button', { name: en.open }).click();
  await second.app.table.waitFor();
  await second.app.review();
  await second.app.text('This is what changes in M1 “calm” of Lancer 07. Everything else stays as it is.').waitFor();
  expect(await second.app.difference()).toEqual(['DT | 3:30 min | 3:20 min']);
  await second.app.tickSafety();
  await second.app.dialog.getByRole('button', { name: 'Write 1 change' }).click();
  await second.app.result('Verified.');
  expect((await second.held())[0]?.times.at(-1)).toBe(20_000);
  await second.app.dialog.getByRole('button', { name: 'Flying this' }).click();
  await second.app.dialog.getByText(/^Flight\slogged\s\d\d:\d\d\s· Lancer\s07\s· /).waitFor();
});
