import type { Records } from '../../src/app/library/files/import-plan.js';
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

/** Chooses a file to import in the library, as a pilot does. */
export async function importFile(app: AppPage, name: string, text: string): Promise<void> {
  const [chooser] = await Promise.all([app.page.waitForEvent('filechooser'), app.button('Import…').click()]);
  await chooser.setFiles({ name, mimeType: 'application/json', buffer: Buffer.from(text) });
}
