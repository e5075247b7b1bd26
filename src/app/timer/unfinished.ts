import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { Keeper, Unfinished, UnfinishedWrite } from '../storage/index.js';

/**
 * The records of jobs that change a timer, from before their first byte until somebody has seen their end. They are in
 * the browser's storage; where that keeps nothing, in this page alone.
 */
export class UnfinishedRecords {
  readonly #list = signal<readonly Unfinished[]>([], { name: 'unfinished' });
  readonly list: ReadonlySignal<readonly Unfinished[]> = this.#list;
  /** Those of writes. */
  readonly writes: ReadonlySignal<readonly UnfinishedWrite[]> = computed(() =>
    this.list.value.filter((record) => record.kind === 'write'),
  );
  readonly #keeper: Keeper<Unfinished>;
  /** As the storage had them at the last look. */
  #stored: readonly Unfinished[] = [];
  /** Changes that the storage has not confirmed yet, or never will; null for a deletion. */
  readonly #open = new Map<string, Unfinished | null>();
  #changes = 0;
  #loading: Promise<void> | null = null;

  /** @param keeper whose calls all end in time, see `limited`. */
  constructor(keeper: Keeper<Unfinished>) {
    this.#keeper = keeper;
  }

  /** Reads the storage again. It may not have answered before. */
  refresh(): Promise<void> {
    this.#loading ??= this.#load().finally(() => {
      this.#loading = null;
    });
    return this.#loading;
  }

  /** Keeps a record. It is in the list at once. @returns false when the browser does not keep it, or not in time. */
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

  /** Forgets a record. It leaves the list at once. */
  async remove(key: string): Promise<void> {
    this.#note(key, null);
    // Where nothing is kept there is nothing to remove.
    await this.#keeper.remove(key).then(
      () => this.#confirmed(key, null),
      () => {},
    );
  }

  /** Tries again what the browser has not confirmed. */
  keepAgain(): void {
    for (const [key, record] of this.#open) void (record ? this.save(record) : this.remove(key));
  }

  async #load(): Promise<void> {
    let seen: number;
    let stored: Unfinished[] | null;
    do {
      seen = this.#changes;
      stored = await this.#keeper.all().catch(() => null);
      // Known records are not forgotten because the storage fails.
      if (!stored) return;
      // Changes from the meantime are not in what was loaded.
    } while (seen !== this.#changes);
    this.#stored = stored;
    this.#publish();
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
