import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { Lack } from '../browser/doors.js';
import type { StorageCall, StorageErrorCode, StorageWatch } from '../storage/index.js';

/** What the browser keeps for this page, judged by what it does: each call of the storage reports here. */
export class Keeping implements StorageWatch {
  /** Why nothing is stored or given back at present; null while all is well. */
  readonly storage: ReadonlySignal<StorageErrorCode | null>;
  /** What else this browser does not have. */
  readonly lacks: ReadonlySignal<readonly Lack[]>;
  /** Whether the pilot has read about everything that is wrong, and wants to see it no longer. */
  readonly dismissed: ReadonlySignal<boolean>;
  /** What fails, by shelf and by what was asked of it. */
  readonly #failing = signal<ReadonlyMap<string, StorageErrorCode>>(new Map());
  readonly #lacks = signal<ReadonlySet<Lack>>(new Set());
  readonly #seen = signal('');
  readonly #now: ReadonlySignal<string>;
  #onKept: (() => void) | null = null;
  #onReturn: () => void = () => {};

  /** @param lacks what was missing when the page opened. */
  constructor(lacks: readonly Lack[] = []) {
    this.#lacks.value = new Set(lacks);
    this.storage = computed(() => [...this.#failing.value.values()][0] ?? null);
    this.lacks = computed(() => [...this.#lacks.value]);
    this.#now = computed(() => [this.storage.value, ...this.lacks.value].join(' '));
    this.dismissed = computed(() => this.#seen.value === this.#now.value);
  }

  answered(shelf: string, kind: StorageCall): void {
    if (kind === 'change') {
      this.#onKept?.();
      this.#onKept = null;
    }
    const failing = new Map(this.#failing.peek());
    const wasShut = failing.delete(`${shelf} read`);
    // A shelf that can be changed can also be read.
    const wasStuck = kind === 'change' && failing.delete(`${shelf} change`);
    if (!wasShut && !wasStuck) return;
    this.#failing.value = failing;
    this.#onReturn();
  }

  failed(shelf: string, kind: StorageCall, code: StorageErrorCode): void {
    const key = `${shelf} ${kind}`;
    if (this.#failing.peek().get(key) !== code) this.#failing.value = new Map(this.#failing.peek()).set(key, code);
  }

  /** Calls back once, as soon as the storage has kept something. */
  onKept(callback: () => void): void {
    this.#onKept = callback;
  }

  /** The pilot comes back to the page, and may have made room in the meantime. */
  tryAgain(): void {
    if (this.storage.peek()) this.#onReturn();
  }

  lack(what: Lack): void {
    this.#lacks.value = new Set([...this.#lacks.value, what]);
  }

  dismiss(): void {
    this.#seen.value = this.#now.value;
  }

  /** Calls back each time that the storage works again after a failure, or that it is worth a try. */
  onReturn(callback: () => void): void {
    this.#onReturn = callback;
  }
}
