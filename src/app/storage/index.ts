import type { InferOutput } from 'valibot';
import { type Change, changeShelves, deleteStorage, type Keeper, openStorage, Shelf, STORES } from './database.js';
import { StorageQuestions, type StorageWatch } from './limit.js';
import type * as records from './records.js';

export type { Change, Keeper } from './database.js';
export { STORES as SHELVES } from './database.js';
export type { StorageCall, StorageWatch } from './limit.js';
export type * from './records.js';
export { isSame } from './same.js';

/** What changes in the library in one step. */
export interface LibraryChange {
  readonly models?: Change<records.ModelRecord>;
  readonly settings?: Change<records.SettingRecord>;
  readonly flights?: Change<records.FlightRecord>;
}

type Records = typeof records.RECORDS;
type Shelves = { readonly [Name in keyof Records]: Keeper<InferOutput<Records[Name]['schema']>> };

/** Everything that the browser keeps, so that it survives a reload, a crash and a flat battery. */
export interface Storage extends Shelves {
  /** Changes the library in one step: all of it is kept, or nothing. */
  change(change: LibraryChange): Promise<void>;
  /** Deletes everything. Nothing can be stored after that until the page is loaded again. */
  erase(): Promise<void>;
}

/** The calls of a shelf, and what each does. The limits apply to all of them. */
export const SHELF_CALLS = {
  save: 'change',
  remove: 'change',
  all: 'read',
} as const satisfies Record<keyof Keeper<never>, 'read' | 'change'>;

/** @param onEmptied see {@link openStorage}. */
export function browserStorage(name = 'sidus-timer', onEmptied?: () => void): Storage {
  const opened = openStorage(name, onEmptied);
  const left = new Map<string, records.AsideRecord>();
  const note = (found: readonly records.AsideRecord[]): void => {
    for (const record of found) left.set(`${record.shelf}/${String((record.stored as { key: unknown }).key)}`, record);
  };
  const shelves = Object.fromEntries(STORES.map((name) => [name, new Shelf(opened, name, note)])) as unknown as Shelves;
  const { aside } = shelves;
  const moved = aside.all.bind(aside);
  aside.all = async () => [...(await moved()), ...left.values()];
  return {
    ...shelves,
    change: (change) => changeShelves(opened, { ...change }),
    erase: () => deleteStorage(opened, name),
  };
}

/** The same storage, but each call ends in time, with its result or an error. */
export function limited(storage: Storage, watch: StorageWatch): Storage {
  const inTime = <Name extends keyof Shelves>(name: Name): readonly [Name, Keeper<{ readonly key: string }>] => {
    const keeper = storage[name] as Keeper<{ readonly key: string }>;
    const questions = new StorageQuestions(watch, name);
    return [
      name,
      {
        save: (record, now) => questions.ask(SHELF_CALLS.save, () => keeper.save(record, now)),
        remove: (key) => questions.ask(SHELF_CALLS.remove, () => keeper.remove(key)),
        all: () => questions.ask(SHELF_CALLS.all, () => keeper.all()),
      },
    ];
  };
  const changes = new StorageQuestions(watch, 'models', 'settings', 'flights');
  return {
    ...(Object.fromEntries(STORES.map(inTime)) as unknown as Shelves),
    change: (change) => changes.ask('change', () => storage.change(change)),
    erase: () => new StorageQuestions(watch, 'all').ask('change', () => storage.erase()),
  };
}
