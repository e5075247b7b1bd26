import { batch, type ReadonlySignal, signal } from '@preact/signals';
import type { Keeper } from '../storage/index.js';
import { type Clash, Clashes } from './clashes.js';
import { merged } from './merged.js';

/** How long a deleted record can be put back, in milliseconds. */
export const UNDO_WAIT = 10_000;

/** The latest time that a record can have. */
const LAST = 8.64e15;

/**
 * When a record is changed that was changed before: now, but always later than before. The clock may have been put back
 * since then, or that of another device may have been ahead; the older version must not count as the newer one.
 */
export function changeTime(before: { readonly changedAt: number } | undefined): number {
  return Math.min(LAST, Math.max(Date.now(), (before?.changedAt ?? 0) + 1));
}

/**
 * One list of the library, in memory as in the storage. A change is on the screen at once. What the browser does not
 * keep stays as long as the page is open, see `unsaved`.
 */
export class Collection<T extends { readonly key: string; readonly changedAt: number }> {
  readonly #list = signal<readonly T[]>([]);
  readonly #loaded = signal(false);
  readonly #failed = signal(false);
  readonly #removed = signal<readonly T[]>([]);
  readonly #unsaved = signal<ReadonlySet<string>>(new Set());
  readonly #refused = signal<ReadonlySet<string>>(new Set());
  /** In their order, without removed ones. */
  readonly list: ReadonlySignal<readonly T[]> = this.#list;
  /** Whether the storage has answered, whatever it said. */
  readonly loaded: ReadonlySignal<boolean> = this.#loaded;
  /** Whether the storage last failed to give its records: what is missing in the list may be there. */
  readonly failed: ReadonlySignal<boolean> = this.#failed;
  /** Removed from the list, and not deleted yet. */
  readonly removed: ReadonlySignal<readonly T[]> = this.#removed;
  /** The keys of records that this page has and the storage does not, or not yet. */
  readonly unsaved: ReadonlySignal<ReadonlySet<string>> = this.#unsaved;
  /** Those among them that the storage has refused. */
  readonly refused: ReadonlySignal<ReadonlySet<string>> = this.#refused;
  readonly #keeper: Keeper<T>;
  readonly #inOrder: (a: T, b: T) => number;
  readonly #onChange: () => void;
  #deleting: ReturnType<typeof setTimeout> | undefined;
  #loading: Promise<boolean> | null = null;
  /** What changed here since the storage was asked, by key (null for deleted): one map for each open question. */
  readonly #since = new Set<Map<string, T | null>>();
  /** What the storage last said that it holds, and what it was told to keep since then, by key. */
  readonly #held = new Map<string, T>();
  readonly #sent = new Map<string, readonly T[]>();
  readonly #clashes: Clashes<T>;
  /** The records on which the pilot has to choose. The storage holds the version of the other tab. */
  readonly clashes: ReadonlySignal<readonly Clash<T>[]>;

  /**
   * @param copyOf makes another record of one, with a new key.
   * @param onChange called when the storage has changed, to tell the other tabs.
   */
  constructor(keeper: Keeper<T>, inOrder: (a: T, b: T) => number, copyOf: (record: T) => T, onChange: () => void) {
    this.#keeper = keeper;
    this.#inOrder = inOrder;
    this.#onChange = onChange;
    this.#clashes = new Clashes(keeper, copyOf);
    this.clashes = this.#clashes.list;
  }

  get(key: string | null): T | undefined {
    return key === null ? undefined : this.list.value.find((each) => each.key === key);
  }

  /**
   * Reads the stored records, unless that is done.
   * Where the browser keeps nothing there are none, until it answers again.
   */
  async load(): Promise<void> {
    this.#loading ??= this.refresh();
    if (!(await this.#loading)) this.#loading = null;
  }

  /**
   * Reads the stored records again, because another tab has changed them. Unsaved records stay, and so do changes made
   * here since the storage was asked.
   * @returns whether the storage has answered.
   */
  async refresh(): Promise<boolean> {
    const since = new Map<string, T | null>();
    this.#since.add(since);
    const kept = await this.#keeper.all().catch(() => null);
    this.#since.delete(since);
    if (kept) {
      const mine = this.#list.peek().filter(({ key }) => this.#unsaved.peek().has(key));
      const records = new Map<string, T>();
      for (const record of [...kept, ...mine]) records.set(record.key, record);
      for (const [key, record] of since) {
        if (record) records.set(key, record);
        else records.delete(key);
      }
      // A record that was changed elsewhere while it was about to be deleted here is not deleted.
      this.#removed.value = this.#removed.peek().filter((record) => !this.#isOther(record, records.get(record.key)));
      this.#hear(kept);
      this.#show([...records.values()]);
    }
    batch(() => {
      this.#loaded.value = true;
      this.#failed.value = kept === null;
    });
    return kept !== null;
  }

  /** Reads one record again: another tab may have just changed it. */
  async look(key: string): Promise<void> {
    const before = this.get(key);
    const now = await this.#keeper.load(key).catch(() => undefined);
    if (now && !this.#unsaved.peek().has(key)) this.#held.set(key, now);
    // A record that was changed here in the meantime, or is not saved, is newer.
    if (now && this.get(key) === before && !this.#unsaved.peek().has(key)) this.#show([...this.#list.peek(), now]);
  }

  /**
   * Saves records. They are in the list at once, also if they were about to be deleted.
   * @returns whether the storage has all of them.
   */
  async save(...records: readonly T[]): Promise<boolean> {
    this.#note(records, false);
    for (const since of this.#since) for (const record of records) since.set(record.key, record);
    const keys = new Set(records.map(({ key }) => key));
    if (this.#removed.peek().some(({ key }) => keys.has(key)))
      this.#removed.value = this.#removed.peek().filter(({ key }) => !keys.has(key));
    this.#show([...this.#list.peek(), ...records]);
    const saved = await Promise.all(records.map((record) => this.#put(record)));
    // A record that has changed again in the meantime is saved by its own call.
    const present = new Set(this.#list.peek());
    this.#note(
      records.filter((record, at) => saved[at] && present.has(record)),
      true,
    );
    const refused = records.flatMap(({ key }, at) => (saved[at] || !this.#unsaved.peek().has(key) ? [] : [key]));
    if (refused.length > 0) this.#refused.value = new Set([...this.#refused.peek(), ...refused]);
    if (saved.includes(true)) this.#onChange();
    return saved.every(Boolean);
  }

  /** Removes some from the list, and deletes them for good after ten seconds, unless somebody puts them back. */
  remove(...keys: readonly string[]): void {
    clearTimeout(this.#deleting);
    this.#removed.value = [...this.#removed.peek(), ...this.#list.peek().filter(({ key }) => keys.includes(key))];
    this.#show(this.#list.peek());
    this.#deleting = setTimeout(() => void this.#deleteUnchanged(), UNDO_WAIT);
  }

  /** Puts removed records back, if they are not deleted yet. */
  undoRemove(): void {
    clearTimeout(this.#deleting);
    const back = this.#removed.peek();
    this.#removed.value = [];
    this.#show([...this.#list.peek(), ...back]);
    // Another tab may have deleted some for good in the meantime.
    void this.save(...back.filter(({ key }) => !this.#held.has(key)));
  }

  /** Deletes the removed records for good: the ten seconds are over, or the pilot leaves the page. */
  flush(): void {
    clearTimeout(this.#deleting);
    const gone = this.#removed.peek().map(({ key }) => key);
    this.#removed.value = [];
    void this.delete(...gone);
  }

  /**
   * Deletes some at once and for good.
   * @returns whether the storage has deleted all of them.
   */
  async delete(...keys: readonly string[]): Promise<boolean> {
    if (keys.length === 0) return true;
    const gone = new Set(keys);
    this.#note(
      keys.map((key) => ({ key })),
      true,
    );
    for (const since of this.#since) for (const key of keys) since.set(key, null);
    this.#show(this.#list.peek().filter(({ key }) => !gone.has(key)));
    const deleted = await Promise.allSettled(keys.map((key) => this.#keeper.remove(key)));
    this.#onChange();
    return deleted.every(({ status }) => status === 'fulfilled');
  }

  /** A record that another tab has changed in the meantime is not deleted, even if that tab has not said so. */
  async #deleteUnchanged(): Promise<void> {
    const gone = this.#removed.peek();
    const due = this.#deleting;
    const held = await Promise.all(gone.map(({ key }) => this.#keeper.load(key).catch(() => undefined)));
    // More was removed in the meantime, and all waits for the ten seconds of that.
    if (this.#deleting !== due) return;
    const changed = held.filter((now, at) => this.#isOther(gone[at] as T, now));
    const isChanged = (key: string): boolean => changed.some((now) => now?.key === key);
    this.#removed.value = this.#removed.peek().filter(({ key }) => !isChanged(key));
    this.flush();
    if (changed.length > 0) await this.refresh();
  }

  /**
   * Whether another tab has put another version of a removed record in its place; it may be an older one, when that tab
   * has undone an import.
   */
  #isOther({ key, changedAt }: T, now: T | undefined): boolean {
    return now !== undefined && now.changedAt !== changedAt && now.changedAt !== this.#held.get(key)?.changedAt;
  }

  /** Tries again to save what the browser has not saved. */
  async keepAgain(): Promise<void> {
    const waiting = this.#list.peek().filter(({ key }) => this.#unsaved.peek().has(key));
    if (waiting.length > 0) await this.save(...waiting);
  }

  /**
   * An unsaved record was made from what the storage held before. That stays known, to merge it with the new content.
   */
  #hear(kept: readonly T[]): void {
    const unsaved = this.#unsaved.peek();
    for (const key of this.#held.keys()) if (!unsaved.has(key)) this.#held.delete(key);
    for (const record of kept) if (!unsaved.has(record.key)) this.#held.set(record.key, record);
  }

  /** The pilot has chosen a version of the first record on which two tabs do not agree. */
  async settle(choice: 'mine' | 'theirs'): Promise<void> {
    const [clash] = this.#clashes.list.peek();
    if (!clash) return;
    this.settled(clash.record.key);
    if (choice === 'mine') await this.save({ ...clash.record, changedAt: changeTime(clash.record) });
  }

  /** The pilot has chosen in another place. */
  settled(key: string): void {
    const copy = this.#clashes.end(key);
    if (!copy) return;
    for (const since of this.#since) since.set(copy.key, null);
    this.#show(this.#list.peek().filter((each) => each.key !== copy.key));
    void Promise.allSettled([this.#keeper.remove(copy.key)]).then(() => this.#onChange());
  }

  /** The page may not come back: see {@link Clashes.keepCopies}. */
  keepClashes(): void {
    this.#clashes.keepCopies();
  }

  /**
   * Puts a record into the storage, merged with what another tab may have just put there.
   * @returns whether it is there; false also when the pilot has to choose.
   */
  async #put(record: T): Promise<boolean> {
    const { key } = record;
    const before = this.#held.get(key);
    const sent = this.#sent.get(key) ?? [];
    this.#sent.set(key, [...sent, record]);
    const known = before ? [before, ...sent] : sent;
    let held: T | null;
    try {
      held = await this.#keeper.exchange({ record, known });
    } catch {
      // It may still get there.
      return false;
    }
    const later = this.#sent.get(key) ?? [];
    this.#sent.set(key, later.slice(later.indexOf(record) + 1));
    this.#held.set(key, held ?? record);
    if (held === null) return true;
    // A newer version of this record will find the same.
    if (this.#list.peek().find((each) => each.key === key) !== record) return false;
    const both = merged(before, record, held);
    if (both.disagreed.length === 0) return await this.save(both.record);
    this.#note([record], true);
    batch(() => {
      this.#clashes.add({ ...both, theirs: held });
      this.#show([...this.#list.peek(), held]);
    });
    return false;
  }

  /** In their order. Of records with the same key, only the last one. */
  #show(records: readonly T[]): void {
    const all = new Map(records.map((record) => [record.key, record]));
    for (const { key } of this.#removed.peek()) all.delete(key);
    this.#list.value = [...all.values()].sort(this.#inOrder);
  }

  #note(records: readonly { readonly key: string }[], isSaved: boolean): void {
    const unsaved = new Set(this.#unsaved.peek());
    for (const { key } of records) {
      if (isSaved) unsaved.delete(key);
      else unsaved.add(key);
    }
    this.#unsaved.value = unsaved;
    const refused = [...this.#refused.peek()].filter((key) => unsaved.has(key));
    if (refused.length < this.#refused.peek().size) this.#refused.value = new Set(refused);
  }
}
