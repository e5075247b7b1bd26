import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import type { Change, Keeper } from './database.js';

/** How long something removed can be put back, in milliseconds. */
const UNDO_WAIT = 10_000;

/** The latest time that a record can have. */
const LAST = 8.64e15;

/**
 * When a record is changed that was changed before: now, but always later than before. The clock may have been put back
 * since then, or that of another device may have been ahead; the older version must not count as the newer one.
 */
export function changeTime(before: { readonly changedAt: number } | undefined): number {
  return Math.min(LAST, Math.max(Date.now(), (before?.changedAt ?? 0) + 1));
}

export function byKey(a: { readonly key: string }, b: { readonly key: string }): number {
  return a.key < b.key ? -1 : 1;
}

/** What a list needs of the storage. */
export interface CollectionParts<T extends { readonly key: string }> {
  /** Default: by key. */
  readonly inOrder?: (a: T, b: T) => number;
  readonly keeper: Keeper<T>;
  /**
   * Changes the list, by its `begin` and `ended`, and the storage. Default: each record by itself.
   * @returns whether the storage has it all.
   */
  readonly change?: (change: Change<T>) => Promise<boolean>;
  /** Deletes for good what was removed from several lists, together. Default: each list for itself. */
  readonly later?: { timer?: ReturnType<typeof setTimeout>; readonly flush: () => void };
}

/**
 * One list of what the page keeps, in memory as in the storage. A change is on the screen at once. What the browser
 * does not keep stays as long as the page is open, see `unsaved`.
 */
export class Collection<T extends { readonly key: string }> {
  readonly #list = signal<readonly T[]>([]);
  readonly #loaded = signal(false);
  readonly #failed = signal(false);
  readonly #removed = signal<readonly T[]>([]);
  readonly #unsaved = signal<ReadonlySet<string>>(new Set());
  readonly #byKey = computed(() => new Map(this.list.value.map((record) => [record.key, record])));
  /** In their order, which may be that of a language, without removed ones. */
  readonly list: ReadonlySignal<readonly T[]> = computed(() =>
    [...this.#list.value].sort(this.#parts.inOrder ?? byKey),
  );
  /** Whether the storage has answered, whatever it said. */
  readonly loaded: ReadonlySignal<boolean> = this.#loaded;
  /** Whether the storage last failed to give its records: what is missing in the list may be there. */
  readonly failed: ReadonlySignal<boolean> = this.#failed;
  /** Removed from the list, and not deleted yet. */
  readonly removed: ReadonlySignal<readonly T[]> = this.#removed;
  /** The keys of records that this page has and the storage does not, or not yet. */
  readonly unsaved: ReadonlySignal<ReadonlySet<string>> = this.#unsaved;
  readonly #parts: CollectionParts<T>;
  #loading: Promise<void> | null = null;
  /** What this page has changed, by key; null for deleted. The storage may not have it yet when it is read. */
  readonly #changes = new Map<string, T | null>();
  /** The keys that this page has deleted and the storage has not, or not yet. */
  readonly #undeleted = new Set<string>();
  readonly #later: NonNullable<CollectionParts<T>['later']>;

  constructor(parts: CollectionParts<T>) {
    this.#parts = parts;
    this.#later = parts.later ?? { flush: () => this.flush() };
  }

  get(key: string | null): T | undefined {
    return key === null ? undefined : this.#byKey.value.get(key);
  }

  /**
   * Reads the stored records, unless that is done.
   * Where the browser keeps nothing there are none, until it answers again.
   */
  async load(): Promise<void> {
    if (!this.#loaded.peek() || this.#failed.peek()) await this.loadAgain();
  }

  /** Reads the stored records once more. */
  loadAgain(): Promise<void> {
    this.#loading ??= this.#read().finally(() => {
      this.#loading = null;
    });
    return this.#loading;
  }

  /**
   * Saves records. They are in the list at once, also if they were about to be deleted.
   * @returns whether the storage has all of them.
   */
  async save(...records: readonly T[]): Promise<boolean> {
    return await this.#change({ put: records });
  }

  /** Deletes some for good. */
  async delete(...keys: readonly string[]): Promise<void> {
    if (keys.length > 0) await this.#change({ gone: keys });
  }

  async #change(change: Change<T>): Promise<boolean> {
    const { keeper, change: together } = this.#parts;
    if (together) return await together(change);
    this.begin(change);
    const gone = (change.gone ?? []).map((key) =>
      keeper.remove(key).then(
        () => this.ended({ gone: [key] }),
        // What cannot be deleted now is deleted another time.
        () => {},
      ),
    );
    const kept = (change.put ?? []).map(async (record) => {
      const isKept = await keeper.save(record).then(
        () => true,
        () => false,
      );
      if (isKept) this.ended({ put: [record] });
      return isKept;
    });
    await Promise.all(gone);
    return (await Promise.all(kept)).every(Boolean);
  }

  /** Removes some from the list, to be deleted for good a while later, unless somebody puts them back. */
  remove(...keys: readonly string[]): void {
    const gone = new Set(keys);
    this.#removed.value = [...this.#removed.peek(), ...this.#list.peek().filter(({ key }) => gone.has(key))];
    this.#show(this.#list.peek());
    clearTimeout(this.#later.timer);
    this.#later.timer = setTimeout(this.#later.flush, UNDO_WAIT);
  }

  /** Puts removed records back, if they are not deleted yet. */
  undoRemove(): void {
    clearTimeout(this.#later.timer);
    const back = this.#removed.peek();
    this.#removed.value = [];
    this.#show([...this.#list.peek(), ...back]);
  }

  /** Deletes for good what was removed: ten seconds are over, or the pilot leaves the page. */
  flush(): void {
    clearTimeout(this.#later.timer);
    void this.delete(...this.#removed.peek().map(({ key }) => key));
  }

  /** The list changes now, before the storage does. */
  begin({ put = [], gone = [] }: Change<T>): void {
    const saved = put.map(({ key }) => key);
    const changed = new Set([...gone, ...saved]);
    batch(() => {
      this.#note(gone, true);
      this.#note(saved, false);
      for (const key of gone) {
        this.#changes.set(key, null);
        this.#undeleted.add(key);
      }
      for (const record of put) {
        this.#changes.set(record.key, record);
        this.#undeleted.delete(record.key);
      }
      if (this.#removed.peek().length > 0)
        this.#removed.value = this.#removed.peek().filter(({ key }) => !changed.has(key));
      this.#show([...this.#list.peek().filter(({ key }) => !changed.has(key)), ...put]);
    });
  }

  /** The storage has done this part of a change. */
  ended({ put = [], gone = [] }: Change<T>): void {
    for (const key of gone) this.#undeleted.delete(key);
    // A record that has changed again in the meantime is saved by its own call.
    const keys = put.filter((record) => this.get(record.key) === record).map(({ key }) => key);
    this.#note(keys, true);
  }

  /** What this page has done and the storage has not: to be done once that works again. */
  get waiting(): Required<Change<T>> {
    return { put: this.#list.peek().filter(({ key }) => this.#unsaved.peek().has(key)), gone: [...this.#undeleted] };
  }

  /** Tries again what the storage has not done. */
  async keepAgain(): Promise<void> {
    await this.#change(this.waiting);
  }

  async #read(): Promise<void> {
    const kept = await this.#parts.keeper.all().catch(() => null);
    batch(() => {
      if (kept) {
        const records = new Map(kept.map((record) => [record.key, record]));
        for (const [key, record] of this.#changes) {
          if (record) records.set(key, record);
          else records.delete(key);
        }
        this.#show([...records.values()]);
      }
      this.#loaded.value = true;
      this.#failed.value = kept === null;
    });
  }

  #show(records: readonly T[]): void {
    const removed = new Set(this.#removed.peek().map(({ key }) => key));
    this.#list.value = records.filter(({ key }) => !removed.has(key));
  }

  #note(keys: readonly string[], isSaved: boolean): void {
    if (keys.length === 0) return;
    const unsaved = new Set(this.#unsaved.peek());
    for (const key of keys) unsaved[isSaved ? 'delete' : 'add'](key);
    this.#unsaved.value = unsaved;
  }
}
