import { type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { loadSetting, saveSetting } from './settings.js';

/** The part of `navigator.locks` that the page uses. */
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
/** How long a reloaded page waits at most for the page before it to release its number, in milliseconds. */
const RELOAD_WAIT = 1000;
/** A tab whose number has been free for so long is closed and not being reloaded. Milliseconds. */
const CLOSED_AFTER = 3000;
/** How long the browser may take to say whether a number is free, in milliseconds. */
const ANSWER_WAIT = 3000;

const lockName = (number: number): string => `sidus-timer/${NAME}/${number}`;

/** Only this tab sees it, and a tab that is duplicated from it. */
export const tabMemory: TabMemory = {
  load: () => loadSetting(NAME, v.pipe(v.number(), v.safeInteger(), v.minValue(1)), 'sessionStorage'),
  save: (number) => saveSetting(NAME, number, 'sessionStorage'),
};

/**
 * The number of this tab among the tabs of this page, from 1. Work is kept for each number separately. A tab keeps its
 * number until it is closed, also over a reload; then the number is free, with the work that was kept under it. Without
 * locks all tabs are 1. Where the browser does not say which tab has which number, this tab takes a number that no
 * other can have, and none of the work of another tab.
 */
export class TabNumber {
  readonly #told = signal(true, { name: 'tabsTold' });
  /** Whether the browser tells its tabs apart; false as soon as it has failed to. */
  readonly told: ReadonlySignal<boolean> = this.#told;
  readonly #locks: Locks | null;
  readonly #memory: TabMemory;
  /** Whether the browser has left a question without an answer. */
  #silent = false;
  #number: number | null = null;

  constructor(locks: Locks | null, memory: TabMemory) {
    this.#locks = locks;
    this.#memory = memory;
    if (!locks) this.#told.value = false;
  }

  get value(): number {
    return this.#number ?? 1;
  }

  /**
   * Takes the number that this tab had before a reload. The page before may still hold it, or the tab from which this
   * one was duplicated.
   */
  async takeBefore(): Promise<void> {
    const before = this.#memory.load();
    if (before === null) return;
    const stop = new AbortController();
    const giveUp = setTimeout(() => stop.abort(), RELOAD_WAIT);
    if (await this.#lock(before, { signal: stop.signal })) this.#number = before;
    clearTimeout(giveUp);
  }

  /** @returns whether this tab now has this number. */
  async take(number: number): Promise<boolean> {
    if (this.#number === null && (await this.#lock(number, { ifAvailable: true }))) this.#have(number);
    return this.#number === number;
  }

  /** Takes the lowest free number, unless this tab has one. */
  async takeAny(): Promise<void> {
    for (let number = 1; this.#number === null; number++) {
      await this.take(number);
      if (this.#silent && this.#number === null) this.#have(this.#memory.load() ?? Date.now());
    }
  }

  /** Whether another tab could take this number; false where the browser does not say. */
  async isFree(number: number): Promise<boolean> {
    return number !== this.#number && (await this.#ask(number, { ifAvailable: true }, Promise.resolve())) === 'taken';
  }

  /** Whether another tab has this number; false where the browser does not say. */
  async isElsewhere(number: number): Promise<boolean> {
    return number !== this.#number && (await this.#ask(number, { ifAvailable: true }, Promise.resolve())) === 'held';
  }

  /**
   * Waits until the tab with this number is closed. A tab that is only reloaded takes its number again.
   * @returns false when the wait was stopped, or where the browser does not say.
   */
  async whenClosed(number: number, stop: AbortSignal): Promise<boolean> {
    try {
      while (this.#locks && !this.#silent) {
        await this.#locks.request(lockName(number), { signal: stop }, async () => {});
        await new Promise((resolve) => setTimeout(resolve, CLOSED_AFTER));
        if (await this.isFree(number)) return true;
      }
    } catch {
      // The wait was stopped or refused.
    }
    return false;
  }

  #have(number: number): void {
    this.#number = number;
    this.#memory.save(number);
  }

  async #lock(number: number, options: Parameters<Locks['request']>[1]): Promise<boolean> {
    return (await this.#ask(number, options)) === 'taken';
  }

  /**
   * @param until hold it until this settles, if it could be taken. Default: until the page is gone.
   * @returns `held`: another tab has it.
   */
  #ask(
    number: number,
    options: Parameters<Locks['request']>[1],
    until: Promise<void> = new Promise(() => {}),
  ): Promise<'taken' | 'held' | 'unknown'> {
    if (this.#silent) return Promise.resolve('unknown');
    return new Promise((resolve) => {
      let over = false;
      const end = (what: 'taken' | 'held' | 'unknown'): void => {
        over = true;
        clearTimeout(giveUp);
        resolve(what);
      };
      const giveUp = setTimeout(() => {
        this.#silent = true;
        this.#told.value = false;
        end('unknown');
      }, ANSWER_WAIT);
      const work = (lock: unknown): Promise<void> | undefined => {
        // A lock that comes too late is released.
        if (lock === null || over) return void end('held');
        end('taken');
        return until;
      };
      // A browser that keeps nothing for this page has no locks for it either.
      const failed = (error?: unknown): void => {
        // The wait ran out: that is an answer, too.
        const isAnswer = (error as { name?: unknown } | undefined)?.name === 'AbortError';
        if (!isAnswer) this.#told.value = false;
        end(isAnswer ? 'held' : 'ifAvailable' in options && number === 1 ? 'taken' : 'unknown');
      };
      const request = async (): Promise<unknown> =>
        this.#locks ? this.#locks.request(lockName(number), options, work) : failed();
      request().catch(failed);
    });
  }
}
