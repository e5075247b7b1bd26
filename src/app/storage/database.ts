import { type DBSchema, deleteDB, type IDBPDatabase, openDB } from 'idb';
import type { BaseIssue, BaseSchema } from 'valibot';
import * as v from 'valibot';
import { service } from '../browser/services.js';
import { whenIdle } from '../browser/when-idle.js';
import { withPresentNames } from './former-names.js';
import { StorageError } from './limit.js';
import type { AsideRecord } from './records.js';
import { isSame } from './same.js';

const STORES = ['drafts', 'unfinished', 'backups', 'ports', 'aside', 'models', 'settings', 'flights'] as const;

/** The shelves of the browser's storage; each record stands under its own key. */
export type StoreName = (typeof STORES)[number];

interface Schema extends DBSchema {
  drafts: { key: string; value: unknown };
  unfinished: { key: string; value: unknown };
  backups: { key: string; value: unknown };
  ports: { key: string; value: unknown };
  aside: { key: string; value: unknown };
  models: { key: string; value: unknown };
  settings: { key: string; value: unknown };
  flights: { key: string; value: unknown };
}

/** A record that is to be kept, and what the shelf may hold of it by now; nothing is always right. */
export interface Exchange<T> {
  readonly record: T;
  readonly known: readonly T[];
}

/** What the models need of a shelf, so that a test can put another in its place. */
export interface Keeper<T extends { readonly key: string }> {
  /** @param now the page is left: at once, ahead of whatever waits. */
  save(record: T, now?: boolean): Promise<void>;
  /**
   * Keeps a record in the place of one that is known here, at one stroke: what another tab has put there is not lost.
   * @returns what the shelf holds instead of a known one, and still holds; null: the record is kept.
   */
  exchange(change: Exchange<T>): Promise<T | null>;
  remove(key: string): Promise<void>;
  /** Undefined when there is none; what is stored and cannot be read is set aside. */
  load(key: string): Promise<T | undefined>;
  /** All records that can be read, in the order of their keys. */
  all(): Promise<T[]>;
}

/** The shelves on which programs lie, of which parts had other names before version 4. */
const RENAMED = ['drafts', 'unfinished', 'backups'] as const;

/** The arrangement of the shelves. A browser refuses it when a newer version of this page has been here. */
const VERSION = 5;

/** Gives the storage once it is open; fails while it is not to be had. */
type Opened = () => Promise<IDBPDatabase<Schema>>;

/**
 * Opens the storage; every use of it fails where the browser keeps nothing, and as long as an old version of this page
 * holds on to it.
 */
export function openStorage(name = 'sidus-timer'): Opened {
  /** What was in the way may have gone: it is open then, after all. */
  let late: IDBPDatabase<Schema> | undefined;
  // Where storage is switched off, opening may throw at once instead of failing later.
  const opened = new Promise<IDBPDatabase<Schema>>((resolve, reject) => {
    if (!service('indexedDB')) return reject(new StorageError('missing', 'the browser has no storage for this page'));
    openDB<Schema>(name, VERSION, {
      async upgrade(database, before, _, change) {
        for (const store of STORES) {
          if (!database.objectStoreNames.contains(store)) database.createObjectStore(store, { keyPath: 'key' });
        }
        if (before === 0 || before >= 4) return;
        for (const store of RENAMED) {
          for await (const entry of change.objectStore(store)) await entry.update(withPresentNames(entry.value));
        }
      },
      blocked: () => reject(new StorageError('blocked', 'another tab holds an older version of the storage')),
      // A newer version of this page wants to rearrange the storage: it goes first.
      blocking: (_, __, event) => (event.target as IDBDatabase).close(),
    }).then((database) => {
      late = database;
      resolve(database);
    }, reject);
  });
  // Whoever asks is told; nobody has asked yet.
  opened.catch(() => {});
  return async () => late ?? (await opened);
}

/** Throws the whole storage away. Other tabs let go of it when they are asked. */
export async function deleteStorage(opened: Opened, name = 'sidus-timer'): Promise<void> {
  // One that could not be opened need not be closed.
  await opened().then(
    (database) => database.close(),
    () => {},
  );
  await deleteDB(name);
}

/**
 * So long a record that is no matter of a moment waits at most for the browser to have nothing else to do, in
 * milliseconds.
 */
const IDLE_WITHIN = 50;

/**
 * Copying a record takes time: what was typed is drawn first. A page that is left, or put away on a phone, may never be
 * idle again.
 */
function drawn(): Promise<void> {
  return new Promise((resolve) => {
    const settled = new AbortController();
    const settle = (): void => {
      settled.abort();
      resolve();
    };
    addEventListener('pagehide', settle, settled);
    document.addEventListener('visibilitychange', settle, settled);
    whenIdle(settle, IDLE_WITHIN);
  });
}

/** One shelf of the storage. What is read from it is checked: another version of this page may have written it. */
export class Shelf<T extends { readonly key: string }> implements Keeper<T> {
  readonly #opened: Opened;
  readonly #name: StoreName;
  readonly #schema: BaseSchema<unknown, T, BaseIssue<unknown>>;
  readonly #durability: IDBTransactionDurability;
  readonly #onLeft: (records: readonly AsideRecord[]) => void;
  /** What waits until the browser has nothing else to do, by key. */
  readonly #waiting = new Map<string, T>();

  /**
   * @param durability `strict`: saved means written to the disk, at the cost of some milliseconds.
   * @param onLeft told of what cannot be read and cannot be set aside either.
   */
  constructor(
    opened: Opened,
    name: StoreName,
    schema: BaseSchema<unknown, T, BaseIssue<unknown>>,
    durability: IDBTransactionDurability = 'relaxed',
    onLeft: (records: readonly AsideRecord[]) => void = () => {},
  ) {
    this.#opened = opened;
    this.#name = name;
    this.#schema = schema;
    this.#durability = durability;
    this.#onLeft = onLeft;
  }

  async save(record: T, now = false): Promise<void> {
    this.#waiting.set(record.key, record);
    if (this.#durability === 'relaxed' && !now) await drawn();
    // One that something has overtaken must not undo it.
    if (this.#waiting.get(record.key) !== record) return;
    this.#waiting.delete(record.key);
    const options = { durability: this.#durability };
    const writing = (await this.#opened()).transaction(this.#name, 'readwrite', options);
    const put = writing.store.put(record);
    // Not left to the page, which may be gone when the record has been put.
    writing.commit?.();
    await Promise.all([put, writing.done]);
  }

  async exchange({ record, known }: Exchange<T>): Promise<T | null> {
    const opened = await this.#opened();
    const changing = opened.transaction(this.#name, 'readwrite', { durability: this.#durability });
    // Whoever waits for it is told by what follows.
    changing.done.catch(() => {});
    const left = new AbortController();
    let saving: Promise<void> | null = null;
    // The page may be gone before the storage has answered: what was typed goes first.
    const leave = (): void => {
      changing.abort();
      saving = this.save(record, true);
    };
    addEventListener('pagehide', leave, left);
    try {
      const stored: unknown = await changing.store.get(record.key);
      const held = v.safeParse(this.#schema, stored);
      // What cannot be read was set aside when it was looked for.
      if (held.success && ![record, ...known].some((each) => isSame(each, held.output))) return held.output;
      left.abort();
      const put = changing.store.put(record);
      changing.commit?.();
      await Promise.all([put, changing.done]);
      return null;
    } catch (cause) {
      if (!saving) throw cause;
      await saving;
      return null;
    } finally {
      left.abort();
    }
  }

  async remove(key: string): Promise<void> {
    this.#waiting.delete(key);
    await (await this.#opened()).delete(this.#name, key);
  }

  async load(key: string): Promise<T | undefined> {
    const stored: unknown = await (await this.#opened()).get(this.#name, key);
    return stored === undefined ? undefined : (await this.#read([stored]))[0];
  }

  async all(): Promise<T[]> {
    return await this.#read(await (await this.#opened()).getAll(this.#name));
  }

  /** What can be read of this; the rest is set aside. */
  async #read(stored: readonly unknown[]): Promise<T[]> {
    const results = stored.map((record) => v.safeParse(this.#schema, record));
    const bad = stored.filter((_, i) => !results[i]?.success);
    if (bad.length > 0) await this.#setAside(bad);
    return results.flatMap((result) => (result.success ? [result.output] : []));
  }

  /**
   * Puts what cannot be read where nothing takes its place. What cannot be moved stays where it is, and is told anyway.
   */
  async #setAside(bad: readonly unknown[]): Promise<void> {
    const at = Date.now();
    const records = bad.map((stored) => {
      const { key } = stored as { key: IDBValidKey };
      return { key: `${this.#name}/${at}/${String(key)}`.slice(0, 1000), shelf: this.#name, at, stored };
    });
    try {
      const moving = (await this.#opened()).transaction([this.#name, 'aside'], 'readwrite');
      for (const { stored, ...record } of records) {
        const { key } = stored as { key: string };
        const now: unknown = await moving.objectStore(this.#name).get(key);
        // Another tab may have put something good in its place, or have been here first.
        if (now === undefined || v.is(this.#schema, now)) continue;
        await moving.objectStore('aside').put({ ...record, stored: now });
        await moving.objectStore(this.#name).delete(key);
      }
      await moving.done;
    } catch {
      this.#onLeft(records);
    }
  }
}
