import { readFile } from 'node:fs/promises';
import type { Records } from '../../src/app/library/files/import-plan.js';
import type { FlightRecord } from '../../src/app/storage/index.js';
import { programOf } from '../app/programs.js';
import { en } from '../tools/en.js';
import type { AppPage } from './app-page.js';

/** Puts a library into the storage of the page, as if earlier visits had left it there. */
export async function fillLibrary({ page }: AppPage, records: Records): Promise<void> {
  await page.evaluate(async (given) => {
    const opening = indexedDB.open('sidus-timer');
    const database = await new Promise<IDBDatabase>((resolve) => {
      opening.onsuccess = () => resolve(opening.result);
    });
    const writing = database.transaction(['models', 'settings', 'flights'], 'readwrite');
    for (const shelf of ['models', 'settings', 'flights'] as const) {
      for (const record of given[shelf]) writing.objectStore(shelf).put(record);
    }
    await new Promise((resolve) => {
      writing.oncomplete = resolve;
    });
    database.close();
  }, records);
}

/** Flights of a contest: one round was flown twice, one is not filled in, and there is a fly-off. */
export function contestDay(): FlightRecord[] {
  const program = programOf('Q', [1000, 30, 100, 300, 18_000]);
  const nothing = { model: null, setting: null, settingName: '', wind: null, temperature: null, note: '' };
  return ['1 240', '2 150', '2 171.5', '3 ', 'fly-off 300'].map((text, at) => {
    const [round = '', result] = text.split(' ');
    const when = { at: Date.UTC(2026, 4, 2, 8 + at), utcOffset: 120, place: 'Gyula', modelName: 'Lancer' };
    const flight = { id: `f${at}`, ...when, ...nothing, program, round, result: result ? Number(result) : null };
    return { key: flight.id, flight, changedAt: 0 };
  });
}

/** Chooses a file in the dialog that this opens, as a pilot does: by default the import of the library. */
export async function chooseFile(
  app: AppPage,
  name: string,
  text: string,
  opens = (): Promise<void> => app.button('Import…').click(),
): Promise<void> {
  const [chooser] = await Promise.all([app.page.waitForEvent('filechooser'), opens()]);
  await chooser.setFiles({ name, mimeType: 'application/json', buffer: Buffer.from(text) });
}

/** The file that goes to the downloads when this is done. */
export async function downloadedBy(
  { page }: AppPage,
  act: () => Promise<void>,
): Promise<{ readonly name: string; readonly text: string }> {
  const [download] = await Promise.all([page.waitForEvent('download'), act()]);
  return { name: download.suggestedFilename(), text: await readFile(await download.path(), 'utf8') };
}

/** Makes a model in the library, with its name in the dialog. */
export async function makeModel(app: AppPage, name: string): Promise<void> {
  await app.button('New model…').click();
  await app.page.getByRole('dialog').getByRole('textbox', { name: 'Name' }).fill(name);
  await app.button(en.save).click();
  await app.page.getByRole('heading', { name }).first().waitFor();
}

/** Makes a program of the model that is shown. */
export async function makeProgram(app: AppPage, name: string): Promise<void> {
  await app.button(en.newProgram.title).click();
  await app.page.getByRole('dialog').getByRole('textbox', { name: 'Name of the program' }).fill(name);
  await app.button(en.newProgram.make).click();
  await app.page.getByRole('article', { name }).waitFor();
}

/** Saves the program on the screen for the first time, under a new model. */
export async function saveFirst(app: AppPage, program: string, model: string): Promise<void> {
  await app.button(en.library.save.open).click();
  await app.field(en.library.save.name({ of: 'program' })).fill(program);
  await app.field(en.library.save.name({ of: 'model' })).fill(model);
  await app.button('Save').click();
  await app.page.getByRole('dialog').waitFor({ state: 'hidden' });
}
