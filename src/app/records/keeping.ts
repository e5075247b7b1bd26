import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { Lack } from '../browser/doors.js';
import type { StorageCall, StorageWatch } from '../storage/index.js';

/** What the browser keeps for this page, judged by what it does: each call of the storage reports here. */
export class Keeping implements StorageWatch {
  /** Whether all is stored and given back; null when the storage does not answer, so that it is not known. */
  readonly kept: ReadonlySignal<boolean | null>;
  /** What else this browser does not have. */
  readonly lacks: ReadonlySignal<readonly Lack[]>;
  /** Whether the pilot has read about all that is wrong, and wants to see it no longer, unless it comes back. */
  readonly dismissed: ReadonlySignal<boolean>;
  /** What fails or does not answer, by shelf and by what was asked of it. */
  readonly #failing = signal<ReadonlyMap<string, false | null>>(new Map());
  readonly #lacks = signal<ReadonlySet<Lack>>(new Set());
  readonly #seen = signal('');
  readonly #now: ReadonlySignal<string>;
  #onKept: (() => void) | null = null;
  #onReturn: () => void = () => {};

  /** @param lacks what was missing when the page opened. */
  constructor(lacks: readonly Lack[] = []) {
    this.#lacks.value = new Set(lacks);
    this.kept = computed(() => {
      const all = [...this.#failing.value.values()];
      return all.includes(false) ? false : all.length === 0 || null;
    });
    this.lacks = computed(() => [...this.#lacks.value]);
    this.#now = computed(() => [String(this.kept.value), ...this.lacks.value].join(' '));
    this.dismissed = computed(() => this.#seen.value === this.#now.value);
  }

  heard(shelf: string, kind: StorageCall, kept: boolean | null): void {
    if (kept) this.#works(shelf, kind);
    else this.#failing.value = new Map(this.#failing.peek()).set(`${shelf} ${kind}`, kept);
  }

  #works(shelf: string, kind: StorageCall): void {
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
    if (failing.size === 0 && !this.#seen.peek().startsWith('true')) this.#seen.value = '';
    this.#onReturn();
  }

  /** Calls back once, as soon as the storage has kept something. */
  onKept(callback: () => void): void {
    this.#onKept = callback;
  }

  /** The pilot comes back to the page, and may have made room in the meantime. */
  tryAgain(): void {
    if (this.kept.peek() !== true) this.#onReturn();
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
