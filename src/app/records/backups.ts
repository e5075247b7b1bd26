import type { TimerProgram } from '../../program/index.js';
import { byKey, Collection } from '../storage/collection.js';
import type { Backup, Keeper } from '../storage/index.js';

/** The most backups before writes that are kept, of real and of simulated timers: years of flying. */
const MOST = 1000;

/** What timers held before they were written, newest first. */
export class Backups extends Collection<Backup> {
  readonly #modelOf: () => string | null;
  /** The keys of the backups of the present timer. */
  #ofTimer = new Set<string>();
  /** The time in the key of the newest backup, at least. */
  #last = 0;

  /** @param modelOf gives the id of the connected timer's model; null when it is not known. */
  constructor(keeper: Keeper<Backup>, modelOf: () => string | null = () => null) {
    super({ inOrder: (a, b) => byKey(b, a), keeper });
    this.#modelOf = modelOf;
  }

  override async load(): Promise<void> {
    await super.load();
    // The clock may have been ahead then: keys keep the order in which the backups were made.
    const newest = Date.parse(this.list.peek()[0]?.key.split('/')[0] ?? '');
    if (newest > this.#last) this.#last = newest;
    this.#deleteOldest();
  }

  /**
   * Keeps a copy. It is in the list at once, and stored when the promise settles.
   * @returns false when the browser keeps nothing: then only this page has it.
   */
  async add(
    program: TimerProgram,
    reason: Backup['reason'],
    simulated: boolean,
    savedAt = Date.now(),
  ): Promise<boolean> {
    // Backups of the same millisecond keep their order, also where the clock has gone back.
    this.#last = Math.max(this.#last + 1, savedAt);
    const key = `${new Date(this.#last).toISOString()}/${program.memory ?? '?'}/${savedAt}`;
    const model = this.#modelOf();
    this.#ofTimer.add(key);
    const backup = { key, savedAt, reason, program, simulated, ...(model === null ? {} : { model }) };
    const isKept = await this.save(backup);
    this.#deleteOldest();
    return isKept;
  }

  /** The timer is, or may be, another one from now on. */
  anotherTimer(): void {
    this.#ofTimer = new Set();
  }

  /** The model is now known to which the present timer belongs: notes it in the backups of that timer. */
  assign(model: string): void {
    const own = this.list.peek().filter((each) => each.model === undefined && this.#ofTimer.has(each.key));
    if (own.length > 0) void this.save(...own.map((each) => ({ ...each, model })));
  }

  /** Those that the pilot asked for stay, and one of a simulated timer pushes out none of a real one. */
  #deleteOldest(): void {
    const written = this.list.peek().filter(({ reason }) => reason === 'write');
    const old = [true, false].flatMap((is) => written.filter(({ simulated }) => simulated === is).slice(MOST));
    void this.delete(...old.map(({ key }) => key));
  }
}
