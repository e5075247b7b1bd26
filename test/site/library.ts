import type { Records } from '../app/library/many.js';
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
