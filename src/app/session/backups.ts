import { type ReadonlySignal, signal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import type { Backup, Keeper } from '../storage/index.js';

/** More than a season's writes; the oldest give way. */
const KEPT = 300;
/** So long a deleted one can be put back, in milliseconds. */
const UNDO_WAIT = 10_000;

/** What timers held before they were written, newest first. */
export class Backups {
  readonly #list = signal<readonly Backup[]>([], { name: 'backups' });
  readonly #removed = signal<readonly Backup[]>([], { name: 'removed' });
  readonly list: ReadonlySignal<readonly Backup[]> = this.#list;
  /** Taken out of the list, and not deleted yet. */
  readonly removed: ReadonlySignal<readonly Backup[]> = this.#removed;
  readonly #keeper: Keeper<Backup>;
  #deleting: ReturnType<typeof setTimeout> | undefined;
  #last = 0;

  constructor(keeper: Keeper<Backup>) {
    this.#keeper = keeper;
  }

  /** Reads what is kept, beside what has been added meanwhile. A browser that keeps nothing has none. */
  async load(): Promise<void> {
    const kept = await this.#keeper.all().catch(() => []);
    this.#list.value = this.#listed([...kept, ...this.list.value]);
  }

  /**
   * Keeps a copy; it is in the list at once, and for good when the promise settles.
   * @throws what the storage says when it keeps nothing.
   */
  async add(program: TimerProgram, reason: Backup['reason'], simulated: boolean, savedAt = Date.now()): Promise<void> {
    // Several in one millisecond keep their order.
    this.#last = Math.max(this.#last + 1, savedAt);
    const key = `${new Date(this.#last).toISOString()}/${program.memory ?? '?'}`;
    const backup: Backup = { key, savedAt, reason, program, simulated };
    const kept = [backup, ...this.list.value];
    this.#list.value = kept.slice(0, KEPT);
    await this.#keeper.save(backup);
    await Promise.all(kept.slice(KEPT).map((old) => this.#keeper.remove(old.key)));
  }

  /** Takes some out of the list, and deletes them for good when nobody has put them back for ten seconds. */
  remove(backups: readonly Backup[]): void {
    clearTimeout(this.#deleting);
    this.#removed.value = [...this.removed.value, ...backups];
    this.#list.value = this.#listed(this.list.value);
    this.#deleting = setTimeout(() => this.flush(), UNDO_WAIT);
  }

  /** Puts back what was taken out, as long as it has not been deleted. */
  undoRemove(): void {
    clearTimeout(this.#deleting);
    const all = [...this.list.value, ...this.removed.value];
    this.#removed.value = [];
    this.#list.value = this.#listed(all);
  }

  /** Deletes for good what was taken out: the time to put it back is over, or the page is left. */
  flush(): void {
    clearTimeout(this.#deleting);
    const { value } = this.removed;
    this.#removed.value = [];
    // What was never kept need not be removed.
    for (const { key } of value) void this.#keeper.remove(key).catch(() => {});
  }

  /** Newest first, each once, without those that were taken out. */
  #listed(backups: readonly Backup[]): Backup[] {
    const all = new Map(backups.map((backup) => [backup.key, backup]));
    for (const { key } of this.removed.value) all.delete(key);
    return [...all.values()].sort((a, b) => (a.key < b.key ? 1 : -1));
  }
}
