import { type Keeper, openStorage, Shelf } from './database.js';
import { within } from './limit.js';
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
export { StorageError, type StorageErrorCode, within } from './limit.js';
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
export function limited({ drafts, unfinished, backups, ports }: Storage): Storage {
  return {
    drafts: inTime(drafts),
    unfinished: inTime(unfinished),
    backups: inTime(backups),
    ports: inTime(ports),
  };
}

function inTime<T extends { readonly key: string }>(keeper: Keeper<T>): Keeper<T> {
  return {
    save: (record) => within(() => keeper.save(record)),
    remove: (key) => within(() => keeper.remove(key)),
    load: (key) => within(() => keeper.load(key)),
    all: () => within(() => keeper.all()),
  };
}
