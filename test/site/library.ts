import type { Records } from '../../src/app/library/files/import-plan.js';
import type { FlightRecord } from '../../src/app/storage/index.js';
import { programOf } from '../app/programs.js';
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

/** Chooses a file to import in the library, as a pilot does. */
export async function importFile(app: AppPage, name: string, text: string): Promise<void> {
  const [chooser] = await Promise.all([app.page.waitForEvent('filechooser'), app.button('Import…').click()]);
  await chooser.setFiles({ name, mimeType: 'application/json', buffer: Buffer.from(text) });
}
