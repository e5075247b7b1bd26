import { type ReadonlySignal, signal } from '@preact/signals';
import type { Keeper } from '../storage/index.js';
import type { Merged } from './merged.js';

/** Another tab has saved a record a moment before this one, and the two do not agree: the pilot is to choose. */
export interface Clash<T> extends Merged<T> {
  /** What the storage holds. */
  readonly theirs: T;
}

/** The records of one list on which two tabs do not agree, until the pilot has said what is to be kept of each. */
export class Clashes<T extends { readonly key: string }> {
  readonly #list = signal<readonly Clash<T>[]>([]);
  readonly list: ReadonlySignal<readonly Clash<T>[]> = this.#list;
  readonly #keeper: Keeper<T>;
  readonly #copyOf: (record: T) => T;
  /** What was put beside a record while the pilot had not answered, by the key of that record. */
  readonly #copies = new Map<string, T>();

  /** @param copyOf makes another record of it, with a key of its own. */
  constructor(keeper: Keeper<T>, copyOf: (record: T) => T) {
    this.#keeper = keeper;
    this.#copyOf = copyOf;
  }

  add(clash: Clash<T>): void {
    this.#list.value = [...this.#list.peek(), clash];
  }

  /**
   * One of them is answered.
   * @returns what was put beside it meanwhile, and is to go; undefined: nothing was.
   */
  end(key: string): T | undefined {
    this.#list.value = this.#list.peek().filter(({ record }) => record.key !== key);
    const copy = this.#copies.get(key);
    this.#copies.delete(key);
    return copy;
  }

  /** The page is left before the pilot has answered, and may not come back: what this tab wanted is kept beside it. */
  keepCopies(): void {
    for (const { record } of this.#list.peek()) {
      if (this.#copies.has(record.key)) continue;
      const copy = this.#copyOf(record);
      this.#copies.set(record.key, copy);
      void this.#keeper.save(copy, true).catch(() => {});
    }
  }
}
