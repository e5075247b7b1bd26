import { type ReadonlySignal, signal } from '@preact/signals';
import type { TabNumber } from '../browser/tab-number.js';
import type { Keeper, Unfinished } from '../storage/index.js';

/**
 * The records of jobs that change a timer, from before their first byte until their end was seen: in the browser's
 * storage, which all tabs share, and in this page alone where that keeps nothing. What another tab has under way is not
 * among them.
 */
export class UnfinishedRecords {
  readonly list: ReadonlySignal<readonly Unfinished[]>;
  readonly #list = signal<readonly Unfinished[]>([], { name: 'unfinished' });
  readonly #keeper: Keeper<Unfinished>;
  readonly #tab: TabNumber;
  /** As the storage has them, by the last look. */
  #stored: readonly Unfinished[] = [];
  /** What the storage has not confirmed yet, or never will: null for one that is to be gone. */
  readonly #open = new Map<string, Unfinished | null>();
  #changes = 0;
  #loading: Promise<void> | null = null;

  /** @param keeper each call of which ends in time, see `limited`. */
  constructor(keeper: Keeper<Unfinished>, tab: TabNumber) {
    this.#keeper = keeper;
    this.#tab = tab;
    this.list = this.#list;
  }

  /** Looks into the storage again: other tabs write there too. */
  refresh(): Promise<void> {
    this.#loading ??= this.#load().finally(() => {
      this.#loading = null;
    });
    return this.#loading;
  }

  /** Keeps a record; it is in the list at once. @returns false when the browser does not keep it, or not in time. */
  async save(record: Unfinished): Promise<boolean> {
    this.#note(record.key, record);
    try {
      await this.#keeper.save(record);
      this.#confirmed(record.key, record);
      return true;
    } catch {
      return false;
    }
  }

  /** Forgets a record; it is out of the list at once. */
  async remove(key: string): Promise<void> {
    this.#note(key, null);
    // Where nothing is kept there is nothing to remove.
    await this.#keeper.remove(key).then(
      () => this.#confirmed(key, null),
      () => {},
    );
  }

  async #load(): Promise<void> {
    let seen: number;
    let tab: number;
    let stored: Unfinished[];
    do {
      seen = this.#changes;
      tab = this.#tab.value;
      const all = await this.#keeper.all().catch(() => null);
      // What was known before is not forgotten because the storage fails.
      if (!all) return;
      const elsewhere = await Promise.all(all.map((record) => this.#isElsewhere(record)));
      stored = all.filter((_, index) => !elsewhere[index]);
      // What was changed meanwhile is not in what was loaded; and by another number other records are this tab's own.
    } while (seen !== this.#changes || tab !== this.#tab.value);
    this.#stored = stored;
    this.#publish();
  }

  /** Whether another tab is at work on it: that tab says what comes of it. A tab that is gone has left it behind. */
  async #isElsewhere(record: Unfinished): Promise<boolean> {
    if (record.kind !== 'write' || record.tab === null || record.tab === this.#tab.value) return false;
    return await this.#tab.isElsewhere(record.tab);
  }

  #note(key: string, record: Unfinished | null): void {
    this.#changes++;
    this.#open.set(key, record);
    this.#publish();
  }

  #confirmed(key: string, record: Unfinished | null): void {
    this.#changes++;
    if (this.#open.get(key) !== record) return;
    this.#open.delete(key);
    const others = this.#stored.filter((stored) => stored.key !== key);
    this.#stored = record ? [...others, record] : others;
  }

  #publish(): void {
    const open = [...this.#open.values()].filter((record) => record !== null);
    this.#list.value = [...this.#stored.filter(({ key }) => !this.#open.has(key)), ...open];
  }
}
