import * as v from 'valibot';
import { loadSetting, saveSetting } from '../storage/settings.js';

/** As much of `navigator.locks` as is used here. */
export interface Locks {
  request(
    name: string,
    options: { readonly ifAvailable: true } | { readonly signal: AbortSignal },
    work: (lock: unknown) => Promise<void> | undefined,
  ): Promise<unknown>;
}

/** Where a tab keeps its number through a reload. */
export interface TabMemory {
  load(): number | null;
  save(number: number): void;
}

const NAME = 'tab';
/** So long a page that is loaded again waits at most for the one before it to let go, in milliseconds. */
const RELOAD_WAIT = 1000;

/** No other tab sees it, but for one that is copied from this one. */
export const tabMemory: TabMemory = {
  load: () => loadSetting(NAME, v.number(), 'sessionStorage'),
  save: (number) => saveSetting(NAME, number, 'sessionStorage'),
};

/**
 * The number of this tab among those of the program, from 1: what is worked on is kept for each by itself. A tab has its number until it is
 * closed, also over a reload; then the number is free, with what was kept under it. Without locks all tabs are 1.
 */
export class TabNumber {
  readonly #locks: Locks | null;
  readonly #memory: TabMemory;
  #number: number | null = null;

  constructor(locks: Locks | null, memory: TabMemory) {
    this.#locks = locks;
    this.#memory = memory;
  }

  get value(): number {
    return this.#number ?? 1;
  }

  /** Takes the number that this tab had before it was loaded again. The page before may still have it, or a tab that this one was copied from. */
  async takeBefore(): Promise<void> {
    const before = this.#memory.load();
    if (before === null) return;
    const stop = new AbortController();
    const giveUp = setTimeout(() => stop.abort(), RELOAD_WAIT);
    if (await this.#lock(before, { signal: stop.signal })) this.#number = before;
    clearTimeout(giveUp);
  }

  /** @returns whether this tab has this number, or has none and could take it. */
  async take(number: number): Promise<boolean> {
    if (this.#number === null && (await this.#lock(number, { ifAvailable: true }))) {
      this.#number = number;
      this.#memory.save(number);
    }
    return this.#number === number;
  }

  /** Takes the lowest number that is free, unless this tab has one. */
  async takeAny(): Promise<void> {
    for (let number = 1; this.#number === null; number++) await this.take(number);
  }

  /** Whether another tab could take this number. */
  async isFree(number: number): Promise<boolean> {
    return number !== this.#number && (await this.#lock(number, { ifAvailable: true }, Promise.resolve()));
  }

  /** @param until for so long it is held, if it could be taken. Default: until the page is gone. */
  #lock(
    number: number,
    options: Parameters<Locks['request']>[1],
    until: Promise<void> = new Promise(() => {}),
  ): Promise<boolean> {
    return new Promise((resolve) => {
      const work = (lock: unknown): Promise<void> | undefined => {
        resolve(lock !== null);
        return lock === null ? undefined : until;
      };
      // A browser that keeps nothing for this page has no locks for it either.
      const failed = (): void => resolve('ifAvailable' in options && number === 1);
      if (this.#locks) this.#locks.request(`sidus-timer/${NAME}/${number}`, options, work).catch(failed);
      else failed();
    });
  }
}
