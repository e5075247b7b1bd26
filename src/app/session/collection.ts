import { batch, type ReadonlySignal, signal } from '@preact/signals';
import type { Keeper } from '../storage/index.js';
import { type Clash, Clashes } from './clashes.js';
import { merged } from './merged.js';

/** So long a deleted record can be put back, in milliseconds. */
const UNDO_WAIT = 10_000;

/**
 * One list of the library: in memory as it is in the storage, and what was changed here is on the screen at once. What
 * the browser does not keep stays for as long as the page is open, see `unsaved`.
 */
export class Collection<T extends { readonly key: string; readonly changedAt: number }> {
  readonly #list = signal<readonly T[]>([]);
  readonly #loaded = signal(false);
  readonly #failed = signal(false);
  readonly #removed = signal<readonly T[]>([]);
  readonly #unsaved = signal<ReadonlySet<string>>(new Set());
  readonly #refused = signal<ReadonlySet<string>>(new Set());
  /** In their order, without those that were taken out. */
  readonly list: ReadonlySignal<readonly T[]> = this.#list;
  /** Whether the storage has been asked, and has answered in one way or another. */
  readonly loaded: ReadonlySignal<boolean> = this.#loaded;
  /** It was asked last and has not given what it holds: what is missing in the list may be there. */
  readonly failed: ReadonlySignal<boolean> = this.#failed;
  /** Taken out of the list, and not deleted yet. */
  readonly removed: ReadonlySignal<readonly T[]> = this.#removed;
  /** What this page has and the storage has not, or not yet, by key. */
  readonly unsaved: ReadonlySignal<ReadonlySet<string>> = this.#unsaved;
  /** Those of them that the storage did not take. */
  readonly refused: ReadonlySignal<ReadonlySet<string>> = this.#refused;
  readonly #keeper: Keeper<T>;
  readonly #inOrder: (a: T, b: T) => number;
  readonly #onChange: () => void;
  #deleting: ReturnType<typeof setTimeout> | undefined;
  #loading: Promise<boolean> | null = null;
  /** What was changed here since the storage was asked, by key, null where it was deleted: one for each question. */
  readonly #since = new Set<Map<string, T | null>>();
  /** What the storage held when it was heard last, and what it was asked to keep since then, by key. */
  readonly #held = new Map<string, T>();
  readonly #sent = new Map<string, readonly T[]>();
  readonly #clashes: Clashes<T>;
  /** Where the pilot has to say what is to be kept. The storage holds what another tab has saved. */
  readonly clashes: ReadonlySignal<readonly Clash<T>[]>;

  /**
   * @param copyOf makes another record of one, with a key of its own.
   * @param onChange called when the storage holds something else than before: for the other tabs.
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

  /** Reads what is kept, unless that is done. A browser that keeps nothing has none, until it answers again. */
  async load(): Promise<void> {
    this.#loading ??= this.refresh();
    if (!(await this.#loading)) this.#loading = null;
  }

  /**
   * Reads again what is kept: another tab has changed it. What is not saved here stays, and so does what was changed
   * here since the storage was asked.
   * @returns whether the storage has answered.
   */
  async refresh(): Promise<boolean> {
    const since = new Map<string, T | null>();
    this.#since.add(since);
    const kept = await this.#keeper.all().catch(() => null);
    this.#since.delete(since);
    if (kept) {
      this.#hear(kept);
      const mine = this.#list.peek().filter(({ key }) => this.#unsaved.peek().has(key));
      const records = new Map<string, T>();
      for (const record of [...kept, ...mine]) records.set(record.key, record);
      for (const [key, record] of since) {
        if (record) records.set(key, record);
        else records.delete(key);
      }
      // What somebody has changed elsewhere while it was about to be deleted here is not deleted.
      this.#removed.value = this.#removed.peek().filter(({ key, changedAt }) => {
        const now = records.get(key);
        return !now || now.changedAt <= changedAt;
      });
      this.#show([...records.values()]);
    }
    batch(() => {
      this.#loaded.value = true;
      this.#failed.value = kept === null;
    });
    return kept !== null;
  }

  /** Reads one record again: another tab may have changed it a moment ago. */
  async look(key: string): Promise<void> {
    const before = this.get(key);
    const now = await this.#keeper.load(key).catch(() => undefined);
    if (now && !this.#unsaved.peek().has(key)) this.#held.set(key, now);
    // What was changed here meanwhile, or is not kept, is newer.
    if (now && this.get(key) === before && !this.#unsaved.peek().has(key)) this.#show([...this.#list.peek(), now]);
  }

  /**
   * Keeps records; they are in the list at once.
   * @returns whether the storage has all of them.
   */
  async save(...records: readonly T[]): Promise<boolean> {
    this.#note(records, false);
    for (const since of this.#since) for (const record of records) since.set(record.key, record);
    this.#show([...this.#list.peek(), ...records]);
    const saved = await Promise.all(records.map((record) => this.#put(record)));
    // What was changed again meanwhile has its own turn.
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

  /** Takes some out of the list, and deletes them for good when nobody has put them back for ten seconds. */
  remove(...keys: readonly string[]): void {
    clearTimeout(this.#deleting);
    this.#removed.value = [...this.#removed.peek(), ...this.#list.peek().filter(({ key }) => keys.includes(key))];
    this.#show(this.#list.peek());
    this.#deleting = setTimeout(() => void this.#deleteUnchanged(), UNDO_WAIT);
  }

  /** Puts back what was taken out, as long as it has not been deleted. */
  undoRemove(): void {
    clearTimeout(this.#deleting);
    const back = this.#removed.peek();
    this.#removed.value = [];
    this.#show([...this.#list.peek(), ...back]);
  }

  /** Deletes for good what was taken out: the time to put it back is over, or the page is left. */
  flush(): void {
    clearTimeout(this.#deleting);
    const gone = this.#removed.peek();
    if (gone.length === 0) return;
    this.#removed.value = [];
    this.#note(gone, true);
    for (const since of this.#since) for (const { key } of gone) since.set(key, null);
    const deleted = gone.map(({ key }) => this.#keeper.remove(key));
    void Promise.allSettled(deleted).then(() => this.#onChange());
  }

  /** What another tab has changed meanwhile is not deleted, also where nobody has told of it. */
  async #deleteUnchanged(): Promise<void> {
    const gone = this.#removed.peek();
    const held = await Promise.all(gone.map(({ key }) => this.#keeper.load(key).catch(() => undefined)));
    const changed = held.filter((now, at) => now && now.changedAt > (gone[at]?.changedAt ?? 0));
    const isChanged = (key: string): boolean => changed.some((now) => now?.key === key);
    this.#removed.value = this.#removed.peek().filter(({ key }) => !isChanged(key));
    this.flush();
    if (changed.length > 0) await this.refresh();
  }

  /** Tries again to keep what the browser has not kept. */
  async keepAgain(): Promise<void> {
    const waiting = this.#list.peek().filter(({ key }) => this.#unsaved.peek().has(key));
    if (waiting.length > 0) await this.save(...waiting);
  }

  /** What is not saved here was made of what was held before: that stays known, so that it is put onto the new. */
  #hear(kept: readonly T[]): void {
    const unsaved = this.#unsaved.peek();
    for (const key of this.#held.keys()) if (!unsaved.has(key)) this.#held.delete(key);
    for (const record of kept) if (!unsaved.has(record.key)) this.#held.set(record.key, record);
  }

  /** The pilot has chosen what is to be kept of the first record on which two tabs do not agree. */
  async settle(choice: 'mine' | 'theirs'): Promise<void> {
    const [clash] = this.#clashes.list.peek();
    if (!clash) return;
    this.settled(clash.record.key);
    if (choice === 'mine') await this.save({ ...clash.record, changedAt: Date.now() });
  }

  /** He has chosen elsewhere. */
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
   * Puts a record into the storage, onto what another tab may have put there a moment ago.
   * @returns whether it is there: false also where the pilot has to choose.
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
      // It may still come there.
      return false;
    }
    const later = this.#sent.get(key) ?? [];
    this.#sent.set(key, later.slice(later.indexOf(record) + 1));
    this.#held.set(key, held ?? record);
    if (held === null) return true;
    // What was changed again meanwhile meets the same.
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

  /** In their order, each once, the last of one key. */
  #show(records: readonly T[]): void {
    const all = new Map(records.map((record) => [record.key, record]));
    for (const { key } of this.#removed.peek()) all.delete(key);
    this.#list.value = [...all.values()].sort(this.#inOrder);
  }

  #note(records: readonly T[], isSaved: boolean): void {
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
