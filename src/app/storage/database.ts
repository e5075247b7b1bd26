import { deleteDB, type IDBPDatabase, openDB } from 'idb';
import * as v from 'valibot';
import { on } from '../browser/lifecycle.js';
import { service } from '../browser/services.js';
import { withPresentNames } from './former-names.js';
import { type AsideRecord, RECORDS } from './records.js';

/** The shelves of the browser's storage. Each record has its own key. */
type StoreName = keyof typeof RECORDS;
export const STORES = Object.keys(RECORDS) as StoreName[];

type Schema = Record<StoreName, { key: string; value: unknown }>;

/** Records of one shelf to put there, and the keys of those to delete. */
export interface Change<T> {
  readonly put?: readonly T[];
  readonly gone?: readonly string[];
}

/** The part of a shelf that the models use, so that a test can put another in its place. */
export interface Keeper<T extends { readonly key: string }> {
  /** @param now the pilot leaves the page: saves at once, before everything that waits. */
  save(record: T, now?: boolean): Promise<void>;
  remove(key: string): Promise<void>;
  /** All readable records, in the order of their keys. Those that cannot be read are set aside. */
  all(): Promise<T[]>;
}

/** The shelves with programs, parts of which had other names before version 4. */
const RENAMED = ['drafts', 'unfinished', 'backups'] as const;

/** The version of the shelves. A browser refuses it when a newer version of this page has been here. */
const VERSION = 5;

/** How long after a refusal a storage that was closed is opened again, in milliseconds. */
const LOOK_AGAIN = 300;

/** Gives the storage once it is open; rejects while it cannot be had. */
type Opened = () => Promise<IDBPDatabase<Schema>>;

/**
 * Opens the storage. Every use of it fails where the browser keeps nothing, and waits while an old version of this page
 * holds it. A browser may close it at any time, as when its data is cleared or its own storage process ends: then the
 * next use opens it again.
 * @param onEmptied called when everything was deleted while this page was open, but not by a tab of this page.
 */
export function openStorage(name: string, onEmptied: () => void = () => {}): Opened {
  let wasOpen = false;
  const forget = (): void => {
    opened = undefined;
  };
  const openOnce = async (): Promise<IDBPDatabase<Schema>> => {
    if (!service('indexedDB')) throw new Error('the browser has no storage for this page');
    let isEmpty = false;
    const database = await openDB<Schema>(name, VERSION, {
      async upgrade(changed, before, _, change) {
        isEmpty = before === 0;
        for (const store of STORES) {
          if (!changed.objectStoreNames.contains(store)) changed.createObjectStore(store, { keyPath: 'key' });
        }
        if (isEmpty || before >= 4) return;
        for (const store of RENAMED) {
          for await (const entry of change.objectStore(store)) await entry.update(withPresentNames(entry.value));
        }
      },
      blocking: (_, version, event) => {
        (event.target as IDBDatabase).close();
        // A newer version of this page changes the storage; the next use says so. What a tab deletes stays closed.
        if (version !== null) forget();
      },
      terminated: () => {
        forget();
        lookAgain();
      },
    });
    if (wasOpen && isEmpty) onEmptied();
    wasOpen = true;
    return database;
  };
  const open = (): Promise<IDBPDatabase<Schema>> => {
    const opening = openOnce();
    // What prevented it may be over with the next try. Each user gets the error.
    opening.catch(() => opened === opening && forget());
    return opening;
  };
  let opened: Promise<IDBPDatabase<Schema>> | undefined = open();
  /** Whether everything was deleted is said at once, not with the next change. While it deletes, a browser refuses. */
  const lookAgain = (tries = 10): void => {
    current().catch(() => {
      if (tries > 0) setTimeout(lookAgain, LOOK_AGAIN, tries - 1);
    });
  };
  const current = (): Promise<IDBPDatabase<Schema>> => {
    opened ??= open();
    return opened;
  };
  return current;
}

/** Deletes the whole storage. */
export async function deleteStorage(opened: Opened, name: string): Promise<void> {
  // A storage that could not be opened need not be closed.
  await opened().then(
    (database) => database.close(),
    () => {},
  );
  await deleteDB(name);
}

/**
 * Changes one or several shelves in one step: all of it is done, or nothing.
 * @param durability `strict`: once it is done it is on the disk, which costs some milliseconds.
 */
export async function changeShelves(
  opened: Opened,
  changes: Readonly<Partial<Record<StoreName, Change<{ readonly key: string }> | undefined>>>,
  durability: IDBTransactionDurability = 'strict',
): Promise<void> {
  const each = Object.entries(changes) as [StoreName, Change<{ readonly key: string }> | undefined][];
  const names = each.filter(([, change]) => change?.put?.length || change?.gone?.length).map(([name]) => name);
  if (names.length === 0) return;
  const changing = (await opened()).transaction(names, 'readwrite', { durability });
  const asked: Promise<unknown>[] = [changing.done];
  try {
    for (const name of names) {
      const { put = [], gone = [] } = changes[name] ?? {};
      const shelf = changing.objectStore(name);
      for (const key of gone) asked.push(shelf.delete(key));
      for (const record of put) asked.push(shelf.put(record));
    }
    // Commits at once: the page may be gone by the time that all is stored.
    changing.commit?.();
  } catch (cause) {
    // What was asked for before the record that cannot be stored.
    changing.abort();
    await Promise.allSettled(asked);
    throw cause;
  }
  await Promise.all(asked);
}

/** How long a record that is not urgent waits at most for an idle browser, in milliseconds. */
const IDLE_WITHIN = 50;

/**
 * Waits until the screen is drawn: copying a record takes time, and what was typed is drawn first. A page that is left,
 * or in the background on a phone, may never be idle again.
 */
function drawn(): Promise<void> {
  return new Promise((resolve) => {
    const settle = (): void => {
      end();
      resolve();
    };
    const end = on('hide', settle);
    // Safari does not have it.
    if (typeof requestIdleCallback === 'function') requestIdleCallback(settle, { timeout: IDLE_WITHIN });
    else setTimeout(settle, IDLE_WITHIN);
  });
}

/** One shelf of the storage. It checks everything that it reads: another version of this page may have written it. */
export class Shelf<T extends { readonly key: string }> implements Keeper<T> {
  readonly #opened: Opened;
  readonly #name: StoreName;
  readonly #schema: v.GenericSchema<unknown, T>;
  readonly #durability: IDBTransactionDurability;
  readonly #onLeft: (records: readonly AsideRecord[]) => void;
  /** Records that wait for an idle browser, by key. */
  readonly #waiting = new Map<string, T>();
  /** The last save of each key. */
  readonly #saving = new Map<string, Promise<void>>();

  /** @param onLeft called with records that can neither be read nor be set aside. */
  constructor(opened: Opened, name: StoreName, onLeft: (records: readonly AsideRecord[]) => void = () => {}) {
    const { schema, durability } = RECORDS[name];
    this.#opened = opened;
    this.#name = name;
    this.#schema = schema as v.GenericSchema<unknown, unknown> as v.GenericSchema<unknown, T>;
    this.#durability = durability;
    this.#onLeft = onLeft;
  }

  save(record: T, now = false): Promise<void> {
    this.#waiting.set(record.key, record);
    const idle = this.#durability === 'relaxed' && !now ? drawn() : Promise.resolve();
    const saving: Promise<void> = idle.then(() => {
      if (this.#waiting.get(record.key) === record) {
        this.#waiting.delete(record.key);
        return changeShelves(this.#opened, { [this.#name]: { put: [record] } }, this.#durability);
      }
      // A newer record has taken its place: it is kept when that is. Or it was deleted.
      const last = this.#saving.get(record.key);
      return last === saving ? undefined : last;
    });
    this.#saving.set(record.key, saving);
    return saving;
  }

  async remove(key: string): Promise<void> {
    this.#waiting.delete(key);
    await changeShelves(this.#opened, { [this.#name]: { gone: [key] } }, this.#durability);
  }

  async all(): Promise<T[]> {
    const stored: unknown[] = await (await this.#opened()).getAll(this.#name);
    const results = stored.map((record) => v.safeParse(this.#schema, record));
    const bad = stored.filter((_, i) => !results[i]?.success);
    if (bad.length > 0) await this.#setAside(bad);
    return results.flatMap((result) => (result.success ? [result.output] : []));
  }

  /**
   * Moves unreadable records to a place where nothing overwrites them. Those that cannot be moved stay, and are
   * reported all the same.
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
        // A good record may have come in its place.
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
