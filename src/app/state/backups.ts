import { signal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import type { Backup, Keeper } from '../storage/index.js';

/** More than a season's writes; the oldest give way. */
const KEPT = 300;

/** What timers held before they were written, newest first. */
export class Backups {
  readonly list = signal<readonly Backup[]>([], { name: 'backups' });
  readonly #keeper: Keeper<Backup>;
  #last = 0;

  constructor(keeper: Keeper<Backup>) {
    this.#keeper = keeper;
  }

  /** Reads what is kept, beside what has been added meanwhile. A browser that keeps nothing has none. */
  async load(): Promise<void> {
    const kept = await this.#keeper.all().catch(() => []);
    const all = new Map([...kept, ...this.list.value].map((backup) => [backup.key, backup]));
    this.list.value = [...all.values()].sort((a, b) => (a.key < b.key ? 1 : -1));
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
    this.list.value = kept.slice(0, KEPT);
    await this.#keeper.save(backup);
    await Promise.all(kept.slice(KEPT).map((old) => this.#keeper.remove(old.key)));
  }

  async remove(backup: Backup): Promise<void> {
    this.list.value = this.list.value.filter(({ key }) => key !== backup.key);
    // What was never kept need not be removed.
    await this.#keeper.remove(backup.key).catch(() => {});
  }
}
