import { type ReadonlySignal, signal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import type { Backup, Keeper } from '../storage/index.js';
import { outdated } from './backup-thinning.js';
import { UNDO_WAIT } from './collection.js';

/** What timers held before they were written, newest first. Thinned by age, see `outdated`. */
export class Backups {
  readonly #list = signal<readonly Backup[]>([], { name: 'backups' });
  readonly #removed = signal<readonly Backup[]>([], { name: 'removed' });
  readonly list: ReadonlySignal<readonly Backup[]> = this.#list;
  /** Removed from the list, and not deleted yet. */
  readonly removed: ReadonlySignal<readonly Backup[]> = this.#removed;
  readonly #keeper: Keeper<Backup>;
  readonly #modelOf: () => string | null;
  /** The keys of backups that the browser does not have, or not yet. */
  readonly #unsaved = new Set<string>();
  /** The keys of the backups of the present timer. */
  #ofTimer = new Set<string>();
  #deleting: ReturnType<typeof setTimeout> | undefined;
  /** The time in the key of the newest backup, at least. */
  #last = 0;

  /** @param modelOf gives the id of the connected timer's model; null when it is not known. */
  constructor(keeper: Keeper<Backup>, modelOf: () => string | null = () => null) {
    this.#keeper = keeper;
    this.#modelOf = modelOf;
  }

  /**
   * Reads the stored backups, in addition to those added in the meantime.
   * Where the browser keeps nothing there are none.
   */
  async load(): Promise<void> {
    const kept = await this.#keeper.all().catch(() => []);
    this.#list.value = this.#listed([...kept, ...this.list.value]);
    // The clock may have been ahead then: keys keep the order in which the backups were made.
    const newest = Date.parse(this.#list.peek()[0]?.key.split('/')[0] ?? '');
    if (newest > this.#last) this.#last = newest;
    this.#thin();
  }

  /**
   * Keeps a copy. It is in the list at once, and stored when the promise settles.
   * @throws the error of the storage when it keeps nothing.
   */
  async add(program: TimerProgram, reason: Backup['reason'], simulated: boolean, savedAt = Date.now()): Promise<void> {
    // Backups of the same millisecond keep their order, also where the clock has gone back.
    this.#last = Math.max(this.#last + 1, savedAt);
    // In another tab the time in the key may be the same then.
    const key = `${new Date(this.#last).toISOString()}/${program.memory ?? '?'}/${savedAt}`;
    const model = this.#modelOf();
    const backup: Backup = { key, savedAt, reason, program, simulated, ...(model === null ? {} : { model }) };
    this.#ofTimer.add(key);
    this.#list.value = [backup, ...this.list.value];
    await this.#save(backup);
    this.#thin();
  }

  /** Tries again to keep what the browser has not kept. */
  keepAgain(): void {
    for (const backup of this.#list.peek()) if (this.#unsaved.has(backup.key)) void this.#save(backup).catch(() => {});
  }

  /** The timer is, or may be, another one from now on. */
  anotherTimer(): void {
    this.#ofTimer = new Set();
  }

  /** The model is now known to which the present timer belongs: notes it in the backups of that timer. */
  assign(model: string): void {
    const own = this.#list
      .peek()
      .filter((each) => each.model === undefined && this.#ofTimer.has(each.key))
      .map((each) => ({ ...each, model }));
    if (own.length === 0) return;
    this.#list.value = this.#listed([...this.#list.peek(), ...own]);
    for (const backup of own) void this.#save(backup).catch(() => {});
  }

  /** Removes some from the list, and deletes them for good after ten seconds, unless somebody puts them back. */
  remove(backups: readonly Backup[]): void {
    clearTimeout(this.#deleting);
    this.#removed.value = [...this.removed.value, ...backups];
    this.#list.value = this.#listed(this.list.value);
    this.#deleting = setTimeout(() => this.flush(), UNDO_WAIT);
  }

  /** Puts removed backups back, if they are not deleted yet. */
  undoRemove(): void {
    clearTimeout(this.#deleting);
    const all = [...this.list.value, ...this.removed.value];
    this.#removed.value = [];
    this.#list.value = this.#listed(all);
  }

  /** Deletes the removed backups for good: the ten seconds are over, or the pilot leaves the page. */
  flush(): void {
    clearTimeout(this.#deleting);
    const { value } = this.removed;
    this.#removed.value = [];
    // A backup that was never stored need not be deleted.
    for (const { key } of value) void this.#keeper.remove(key).catch(() => {});
  }

  async #save(backup: Backup): Promise<void> {
    this.#unsaved.add(backup.key);
    await this.#keeper.save(backup);
    this.#unsaved.delete(backup.key);
  }

  /** Deletes the outdated backups for good. What cannot be deleted now is deleted another time. */
  #thin(): void {
    const gone = new Set(outdated(this.#list.peek(), Date.now()));
    if (gone.size === 0) return;
    this.#list.value = this.#list.peek().filter((each) => !gone.has(each));
    for (const { key } of gone) void this.#keeper.remove(key).catch(() => {});
  }

  /** Newest first, each once, without removed ones. */
  #listed(backups: readonly Backup[]): Backup[] {
    const all = new Map(backups.map((backup) => [backup.key, backup]));
    for (const { key } of this.removed.value) all.delete(key);
    return [...all.values()].sort((a, b) => (a.key < b.key ? 1 : -1));
  }
}
