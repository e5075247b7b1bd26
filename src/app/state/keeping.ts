import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import type { StorageCall, StorageErrorCode, StorageWatch } from '../storage/index.js';
import type { TabNumber } from './tab-number.js';

/**
 * What a browser may not have for this page, besides its storage: `locks` tell its tabs apart, over the `channel` they speak with each
 * other, `settings` are small choices, `offline` is the page itself for when there is no network.
 */
export type Lack = 'locks' | 'channel' | 'settings' | 'offline';

/** What the browser keeps for this page, by what it does: each call of the storage is told here. */
export class Keeping implements StorageWatch {
  /** Why nothing is kept, or given back, just now; null while all is well. */
  readonly storage: ReadonlySignal<StorageErrorCode | null>;
  /** What else this browser does not have. */
  readonly lacks: ReadonlySignal<readonly Lack[]>;
  /** Whether the pilot has been told of all that is wrong, and does not want to see it any longer. */
  readonly dismissed: ReadonlySignal<boolean>;
  readonly #calls = signal<Readonly<Record<StorageCall, StorageErrorCode | null>>>({ read: null, change: null });
  readonly #lacks = signal<ReadonlySet<Lack>>(new Set());
  readonly #seen = signal('');
  readonly #now: ReadonlySignal<string>;
  #onKept: (() => void) | null = null;

  /** @param lacks what was missing when the page was opened. */
  constructor(tab: TabNumber, lacks: readonly Lack[] = []) {
    this.#lacks.value = new Set(lacks);
    this.storage = computed(() => this.#calls.value.change ?? this.#calls.value.read);
    this.lacks = computed(() => [...this.#lacks.value, ...(tab.told.value ? [] : (['locks'] as const))]);
    this.#now = computed(() => [this.storage.value, ...this.lacks.value].join(' '));
    this.dismissed = computed(() => this.#seen.value === this.#now.value);
  }

  answered(kind: StorageCall): void {
    if (kind === 'change') {
      this.#onKept?.();
      this.#onKept = null;
    }
    // What can be changed can be read.
    this.#calls.value = kind === 'change' ? { read: null, change: null } : { ...this.#calls.value, read: null };
  }

  failed(kind: StorageCall, code: StorageErrorCode): void {
    if (this.#calls.value[kind] !== code) this.#calls.value = { ...this.#calls.value, [kind]: code };
  }

  /** Calls back once, as soon as the storage has kept something. */
  onKept(callback: () => void): void {
    this.#onKept = callback;
  }

  lack(what: Lack): void {
    this.#lacks.value = new Set([...this.#lacks.value, what]);
  }

  dismiss(): void {
    this.#seen.value = this.#now.value;
  }

  /** Calls back each time the storage gives back again what it did not before. */
  onReturn(callback: () => void): void {
    let was: StorageErrorCode | null = null;
    effect(() => {
      const { read } = this.#calls.value;
      const returned = was !== null && read === null;
      was = read;
      if (returned) queueMicrotask(callback);
    });
  }
}
