import { type Keeper, openStorage, Shelf } from './database.js';
import { StorageQuestions, type StorageWatch } from './limit.js';
import {
  type Backup,
  backupSchema,
  type Draft,
  draftSchema,
  type PortRecord,
  portSchema,
  type Unfinished,
  unfinishedSchema,
} from './records.js';

export type { Keeper } from './database.js';
export { type StorageCall, StorageError, type StorageErrorCode, type StorageWatch, within } from './limit.js';
export type { Backup, Draft, PortRecord, Unfinished, UnfinishedWalk, UnfinishedWrite } from './records.js';

/** All that is kept in the browser, so that it survives a reload, a crash and a flat battery. */
export interface Storage {
  readonly drafts: Keeper<Draft>;
  readonly unfinished: Keeper<Unfinished>;
  readonly backups: Keeper<Backup>;
  readonly ports: Keeper<PortRecord>;
}

export function browserStorage(name?: string): Storage {
  const opened = openStorage(name);
  return {
    drafts: new Shelf(opened, 'drafts', draftSchema),
    unfinished: new Shelf(opened, 'unfinished', unfinishedSchema, 'strict'),
    backups: new Shelf(opened, 'backups', backupSchema, 'strict'),
    ports: new Shelf(opened, 'ports', portSchema),
  };
}

/** The same storage, each call of which ends in time: with what it gives, or with a StorageError. */
export function limited({ drafts, unfinished, backups, ports }: Storage, watch: StorageWatch): Storage {
  const questions = new StorageQuestions(watch);
  const inTime = <T extends { readonly key: string }>(keeper: Keeper<T>): Keeper<T> => ({
    save: (record) => questions.ask('change', () => keeper.save(record)),
    remove: (key) => questions.ask('change', () => keeper.remove(key)),
    load: (key) => questions.ask('read', () => keeper.load(key)),
    all: () => questions.ask('read', () => keeper.all()),
  });
  return {
    drafts: inTime(drafts),
    unfinished: inTime(unfinished),
    backups: inTime(backups),
    ports: inTime(ports),
  };
}
