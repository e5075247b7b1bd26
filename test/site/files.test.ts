import { readFile } from 'node:fs/promises';
import type { Page } from 'playwright';
import { expect, inject, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { filesMessages } from '../../src/app/messages/en-files.js';
import { libraryMessages } from '../../src/app/messages/en-library.js';
import { formatLibraryFile, type Library, parseLibraryFile } from '../../src/program/index.js';
import { FLIGHT, MODEL, SETTING } from '../program/library-examples.js';
import { AppPage } from './app-page.js';
import { importFile } from './library.js';
import { newPage } from './page.js';

/** A season: three models, twelve settings, thirty flights. */
const SEASON: Library = {
  models: ['Lancer 07', 'Vega 12', 'Pilatus'].map((name, at) => ({ ...MODEL, id: `m${at}`, name })),
  settings: Array.from({ length: 12 }, (_, at) => ({
    ...SETTING,
    id: `s${at}`,
    model: `m${at % 3}`,
    name: `setting ${at}`,
    program: { ...SETTING.program, times: SETTING.program.times.map((time) => time + at) },
  })),
  flights: Array.from({ length: 30 }, (_, at) => ({
    ...FLIGHT,
    id: `f${at}`,
    at: FLIGHT.at + at,
    model: `m${at % 3}`,
    setting: `s${at % 12}`,
  })),
};
const TEXT = formatLibraryFile(SEASON, { writtenAt: Date.UTC(2026, 10, 1), writtenBy: 'a test' });

/** Drops a text on the page, as a file from the desktop. */
async function drop(page: Page, name: string, text: string): Promise<void> {
  await page.evaluate(
    ([title, content]) => {
      const dataTransfer = new DataTransfer();
      dataTransfer.items.add(new File([content], title));
      for (const type of ['dragover', 'drop']) {
        document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }));
      }
    },
    [name, text] as const,
  );
}

async function opened(): Promise<AppPage> {
  const app = await AppPage.open({ acceptDownloads: true });
  await app.page.evaluate(() => location.assign('#library'));
  await app.button('Import…').waitFor();
  return app;
}

async function takeAll(app: AppPage): Promise<void> {
  await app.button('Import 45').click();
  await app.text(/^Imported from .*: 3\smodels, 12\sprograms, 30\sflights\.$/).waitFor();
}

/** The library as in a file of the page, each list in the order of its ids. */
async function exported(app: AppPage): Promise<Library> {
  const [download] = await Promise.all([app.page.waitForEvent('download'), app.button('Export all…').click()]);
  expect(download.suggestedFilename()).toMatch(/^Sidus library \d{4}-\d\d-\d\d\.sidus\.json$/);
  const { library, ignored } = parseLibraryFile(await readFile(await download.path(), 'utf8'));
  expect(ignored).toEqual([]);
  const byId = <T extends { readonly id: string }>(list: readonly T[]): T[] =>
    [...list].sort((a, b) => a.id.localeCompare(b.id, 'en', { numeric: true }));
  return { models: byId(library.models), settings: byId(library.settings), flights: byId(library.flights) };
}

test('what did not come of the page comes when the pilot tries again', async () => {
  const faults: string[] = [];
  const page = await newPage({ serviceWorkers: 'block' }, faults);
  let asked = 0;
  await page.route(/\/all-else-[^/]*\.js$/, async (route) => {
    await (++asked <= 2 ? route.abort() : route.continue());
  });
  await page.goto(inject('site'));
  await page.getByText(en.parts.failed).waitFor();
  await page.getByRole('button', { name: en.parts.again }).click();
  await page.getByText(en.parts.failed).waitFor({ state: 'detached' });
  await new AppPage(page).hasParts();
  expect(asked).toBeGreaterThan(2);
  expect(new Set(faults)).toEqual(new Set(['Failed to load resource: net::ERR_FAILED']));
});

test('a season goes into one file, the device is emptied, and the file brings all of it back', async () => {
  const app = await opened();
  const { page } = app;
  await drop(page, 'season.sidus.json', TEXT);
  await takeAll(app);
  const before = await exported(app);
  expect(before).toEqual(SEASON);

  await app.goTo('Settings');
  await app.button(en.erase.open).click();
  await Promise.all([page.waitForEvent('load'), app.button(en.erase.start).click()]);
  await page.evaluate(() => location.assign('#library'));
  await app.text(libraryMessages.empty.title).waitFor();
  const text = formatLibraryFile(before, { writtenAt: Date.now(), writtenBy: 'a test' });
  await importFile(app, 'back.sidus.json', text);
  await takeAll(app);
  await page.reload();
  await page.getByRole('link', { name: /^Lancer 07/ }).click();
  await page.getByRole('link', { name: /^setting 9/ }).waitFor();
  await page.evaluate(() => location.assign('#library'));
  expect(await exported(app)).toEqual(SEASON);
});

test('the list of commands has Import and Export', async () => {
  const app = await opened();
  const { page } = app;
  await app.goTo('Settings');
  const command = async (name: string): Promise<void> => {
    await page.keyboard.press('Control+k');
    await page.getByRole('combobox', { name: en.palette.search }).fill(name);
    await page.keyboard.press('Enter');
  };
  const [chooser] = await Promise.all([page.waitForEvent('filechooser'), command('import')]);
  await chooser.setFiles({ name: 'season.sidus.json', mimeType: 'application/json', buffer: Buffer.from(TEXT) });
  await takeAll(app);
  const [download] = await Promise.all([page.waitForEvent('download'), command('export all')]);
  expect(parseLibraryFile(await readFile(await download.path(), 'utf8')).library.flights).toHaveLength(30);
});

test('a file that the system opens is shown', async () => {
  const app = await AppPage.open({
    before: () => {
      let consumer: (launch: { files: FileSystemFileHandle[] }) => void;
      Object.assign(window, {
        openWith: async (text: string) => {
          const root = await navigator.storage.getDirectory();
          const handle = await root.getFileHandle('sent.sidus', { create: true });
          const stream = await handle.createWritable();
          await stream.write(text);
          await stream.close();
          consumer({ files: [handle] });
        },
      });
      Object.defineProperty(window, 'launchQueue', {
        value: {
          setConsumer: (given: typeof consumer) => {
            consumer = given;
          },
        },
      });
    },
  });
  const { page } = app;
  await app.hasParts();
  await page.evaluate((text) => (window as unknown as { openWith(text: string): Promise<void> }).openWith(text), TEXT);
  await page.getByRole('heading', { name: filesMessages.import.title('sent.sidus') }).waitFor();
  await takeAll(app);
});
