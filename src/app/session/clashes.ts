import { type ReadonlySignal, signal } from '@preact/signals';
import type { Keeper } from '../storage/index.js';
import type { Merged } from './merged.js';

/** Another tab has saved a record just before this one, and the two do not agree: the pilot has to choose. */
export interface Clash<T> extends Merged<T> {
  /** What the storage holds. */
  readonly theirs: T;
}

/** The records of one list on which two tabs do not agree, until the pilot has chosen. */
export class Clashes<T extends { readonly key: string }> {
  readonly #list = signal<readonly Clash<T>[]>([]);
  readonly list: ReadonlySignal<readonly Clash<T>[]> = this.#list;
  readonly #keeper: Keeper<T>;
  readonly #copyOf: (record: T) => T;
  /** Copies that were stored beside a record before the pilot had chosen, by the key of that record. */
  readonly #copies = new Map<string, T>();

  /** @param copyOf makes another record of it, with a new key. */
  constructor(keeper: Keeper<T>, copyOf: (record: T) => T) {
    this.#keeper = keeper;
    this.#copyOf = copyOf;
  }

  add(clash: Clash<T>): void {
    this.#list.value = [...this.#list.peek(), clash];
  }

  /**
   * The pilot has chosen for one of them.
   * @returns the copy that was stored in the meantime and has to go; undefined for none.
   */
  end(key: string): T | undefined {
    this.#list.value = this.#list.peek().filter(({ record }) => record.key !== key);
    const copy = this.#copies.get(key);
    this.#copies.delete(key);
    return copy;
  }

  /** The pilot leaves the page without choosing, and may not come back: stores this tab's version as a copy. */
  keepCopies(): void {
    for (const { record } of this.#list.peek()) {
      if (this.#copies.has(record.key)) continue;
      const copy = this.#copyOf(record);
      this.#copies.set(record.key, copy);
      void this.#keeper.save(copy, true).catch(() => {});
    }
  }
}
