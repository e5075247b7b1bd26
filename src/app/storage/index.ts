import { isLeaving } from '../browser/lifecycle.js';
import { type Change, changeShelves, deleteStorage, type Keeper, openStorage, Shelf } from './database.js';
import { StorageQuestions, type StorageWatch } from './limit.js';
import {
  type AsideRecord,
  asideSchema,
  type Backup,
  backupSchema,
  type Draft,
  draftSchema,
  type FlightRecord,
  flightSchema,
  type ModelRecord,
  modelSchema,
  type PortRecord,
  portSchema,
  type SettingRecord,
  settingSchema,
  type Unfinished,
  unfinishedSchema,
} from './records.js';

export type { Change, Keeper } from './database.js';
export type { StorageCall, StorageWatch } from './limit.js';
export type {
  AsideRecord,
  Backup,
  Draft,
  FlightRecord,
  ModelRecord,
  PortRecord,
  SettingRecord,
  Unfinished,
  UnfinishedRoundTrip,
  UnfinishedWrite,
} from './records.js';

export { isSame } from './same.js';

/** What changes in the library in one step. */
export interface LibraryChange {
  readonly models?: Change<ModelRecord>;
  readonly settings?: Change<SettingRecord>;
  readonly flights?: Change<FlightRecord>;
}

/** Everything that the browser keeps, so that it survives a reload, a crash and a flat battery. */
export interface Storage {
  readonly drafts: Keeper<Draft>;
  readonly unfinished: Keeper<Unfinished>;
  readonly backups: Keeper<Backup>;
  readonly ports: Keeper<PortRecord>;
  /** Records of the other shelves that cannot be read. */
  readonly aside: Keeper<AsideRecord>;
  readonly models: Keeper<ModelRecord>;
  readonly settings: Keeper<SettingRecord>;
  readonly flights: Keeper<FlightRecord>;
  /** Changes the library in one step: all of it is kept, or nothing. */
  change(change: LibraryChange): Promise<void>;
  /** Deletes everything. Nothing can be stored after that until the page is loaded again. */
  erase(): Promise<void>;
}

/** The calls of a shelf, and what each does. The limits apply to all of them. */
export const SHELF_CALLS = {
  save: 'change',
  remove: 'change',
  load: 'read',
  all: 'read',
} as const satisfies Record<keyof Keeper<never>, 'read' | 'change'>;
/** The shelves, by their names in {@link Storage}. */
export const SHELVES = [
  'drafts',
  'unfinished',
  'backups',
  'ports',
  'aside',
  'models',
  'settings',
  'flights',
] as const satisfies readonly Exclude<keyof Storage, 'change' | 'erase'>[];

/** @param onEmptied see {@link openStorage}. */
export function browserStorage(name = 'sidus-timer', onEmptied?: () => void): Storage {
  const opened = openStorage(name, onEmptied);
  const left = new Map<string, AsideRecord>();
  const note = (records: readonly AsideRecord[]): void => {
    for (const record of records)
      left.set(`${record.shelf}/${String((record.stored as { key: unknown }).key)}`, record);
  };
  const aside = new Shelf(opened, 'aside', asideSchema);
  return {
    drafts: new Shelf(opened, 'drafts', draftSchema, 'relaxed', note),
    unfinished: new Shelf(opened, 'unfinished', unfinishedSchema, 'strict', note),
    backups: new Shelf(opened, 'backups', backupSchema, 'strict', note),
    ports: new Shelf(opened, 'ports', portSchema, 'relaxed', note),
    aside: {
      save: (record) => aside.save(record),
      remove: (key) => aside.remove(key),
      load: (key) => aside.load(key),
      all: async () => [...(await aside.all()), ...left.values()],
    },
    models: new Shelf(opened, 'models', modelSchema, 'strict', note),
    settings: new Shelf(opened, 'settings', settingSchema, 'strict', note),
    flights: new Shelf(opened, 'flights', flightSchema, 'strict', note),
    change: (change) => changeShelves(opened, { ...change }),
    erase: () => deleteStorage(opened, name),
  };
}

/** The same storage, but each call ends in time, with its result or an error. */
export function limited(storage: Storage, watch: StorageWatch): Storage {
  const inTime = <T extends { readonly key: string }>(keeper: Keeper<T>, name: string): Keeper<T> => {
    const questions = new StorageQuestions(watch, name);
    return {
      save: (record, now) => questions.ask(SHELF_CALLS.save, () => keeper.save(record, now), now),
      remove: (key) => questions.ask(SHELF_CALLS.remove, () => keeper.remove(key), isLeaving()),
      load: (key) => questions.ask(SHELF_CALLS.load, () => keeper.load(key)),
      all: () => questions.ask(SHELF_CALLS.all, () => keeper.all()),
    };
  };
  const changes = new StorageQuestions(watch, 'models', 'settings', 'flights');
  return {
    drafts: inTime(storage.drafts, 'drafts'),
    unfinished: inTime(storage.unfinished, 'unfinished'),
    backups: inTime(storage.backups, 'backups'),
    ports: inTime(storage.ports, 'ports'),
    aside: inTime(storage.aside, 'aside'),
    models: inTime(storage.models, 'models'),
    settings: inTime(storage.settings, 'settings'),
    flights: inTime(storage.flights, 'flights'),
    change: (change) => changes.ask('change', () => storage.change(change), isLeaving()),
    erase: () => new StorageQuestions(watch, 'all').ask('change', () => storage.erase()),
  };
}
