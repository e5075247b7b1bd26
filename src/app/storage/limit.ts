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

  constructor(watch: StorageWatch, ...shelves: string[]) {
    this.#watch = watch;
    this.#shelves = shelves;
  }

  /** @throws the error of the browser, or NoAnswer. */
  async ask<T>(kind: StorageCall, work: () => Promise<T>): Promise<T> {
    const tell = (kept: boolean | null): void => {
      for (const shelf of this.#shelves) this.#watch.heard(shelf, kind, kept);
    };
    const settled = (kept: boolean): void => {
      this.#limit = LIMIT;
      tell(kept);
    };
    const asked = async (): Promise<T> => work();
    const answer = asked();
    answer.then(
      () => settled(true),
      () => settled(false),
    );
    try {
      return await attempt(() => answer, this.#limit);
    } catch (error) {
      if (error instanceof NoAnswer) {
        this.#limit = SHORT_LIMIT;
        tell(null);
      }
      throw error;
    }
  }
}
