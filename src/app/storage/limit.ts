import { on } from '../browser/lifecycle.js';
import { attempt, NoAnswer } from '../browser/services.js';

/** How long the storage may take for one call, in milliseconds. */
const LIMIT = 5000;
/**
 * How long a storage may take that did not answer before: nobody should wait for it again and again. In milliseconds.
 */
const SHORT_LIMIT = 250;

/** The two kinds of calls: to give something back, or to store or delete something. */
export type StorageCall = 'read' | 'change';

/** Hears how the storage works. */
export interface StorageWatch {
  /**
   * @param kept whether it has given something back, or kept it; also when that came too late for the caller. Null: it
   * has not answered.
   */
  heard(shelf: string, kind: StorageCall, kept: boolean | null): void;
}

/** Asks some shelves of a storage, and waits only as long as its earlier answers make sensible. */
export class StorageQuestions {
  readonly #watch: StorageWatch;
  readonly #shelves: readonly string[];
  #limit = LIMIT;
  #changes: Promise<unknown> = Promise.resolve();
  /** Sends those that wait for their turn, in their order. */
  readonly #waiting = new Set<() => void>();
  /** How many changes have been answered, each in its turn. */
  #answers = 0;

  constructor(watch: StorageWatch, ...shelves: string[]) {
    this.#watch = watch;
    this.#shelves = shelves;
    on('leave', () => this.#send());
  }

  /**
   * @param now at once, with the changes before it: the pilot leaves the page, and no answer may come any more.
   * @throws the error of the browser, or NoAnswer.
   */
  async ask<T>(kind: StorageCall, work: () => Promise<T>, now = false): Promise<T> {
    const limit = this.#limit;
    // A late change must not undo a later one: changes go one by one, however long that takes.
    const waits = kind === 'change' && !now;
    const answer = new Promise<T>((resolve, reject) => {
      const send = (): void => {
        if (!this.#waiting.delete(send)) return;
        const sent = async (): Promise<T> => work();
        sent().then(resolve, reject);
      };
      this.#waiting.add(send);
      if (waits) void this.#changes.then(send);
      else if (kind === 'read') send();
      else this.#send();
    });
    // Without the results: each would hold the one before, for as long as the page is open.
    if (kind === 'change') this.#changes = Promise.allSettled([this.#changes, answer]).then(() => {});
    const tell = (kept: boolean | null): void => {
      for (const shelf of this.#shelves) this.#watch.heard(shelf, kind, kept);
    };
    const settled = (kept: boolean): void => {
      if (waits) this.#answers++;
      this.#limit = LIMIT;
      tell(kept);
    };
    answer.then(
      () => settled(true),
      () => settled(false),
    );
    try {
      // Thousands of changes take long on any disk. The storage is slow only when it answers none of them.
      return await attempt(
        () => answer,
        limit,
        () => (waits ? this.#answers : 0),
      );
    } catch (error) {
      if (error instanceof NoAnswer) {
        this.#limit = SHORT_LIMIT;
        tell(null);
      }
      throw error;
    }
  }
  /** The pilot leaves the page: all that wait have their turn now, in their order. */
  #send(): void {
    for (const each of this.#waiting) each();
  }
}
