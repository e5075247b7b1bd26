import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import type { Identity } from '../../protocol/index.js';
import { kindKey } from './record-keys.js';

/** What the pilot must know about the memory that flies next. Memories count from 0. */
export type NextFlightWord =
  /** The timer says that another memory is current than is meant. `original` is the one that is meant, if known. */
  | { readonly code: 'other'; readonly memory: number; readonly original: number | null }
  /** Others were selected, and it is not known which is current. `asked` was selected last, if that is known. */
  | { readonly code: 'unknown'; readonly asked: number | null; readonly original: number | null };

/** A memory that flies next because the pilot has made it so. `before` flew at connect; null when it is not known. */
export interface ChosenFlight {
  readonly memory: number;
  readonly before: number | null;
}

/**
 * The current memory is what flies next. Only selecting one (SETMEMORY) changes it. This page does so when the pilot
 * asks for it, or to read others and come back. So it remembers which memory is meant, that of connecting or the one
 * that the pilot has chosen since, and warns when another one is current.
 */
export class NextFlight {
  readonly #open = signal(false, { name: 'memoryOpen' });
  readonly #original = signal<number | null>(null, { name: 'original' });
  readonly #came = signal<number | null>(null, { name: 'came' });
  /** The memory that the timer last named. */
  readonly #current = signal<number | null>(null, { name: 'current' });
  /** Whether other memories were selected since the one that is meant was current. */
  readonly #left = signal(false, { name: 'left' });
  readonly #asked = signal<number | null>(null, { name: 'asked' });
  /**
   * Whether no memory was read since the timer came, or since another one was selected: nobody knows which one is
   * current.
   */
  readonly open: ReadonlySignal<boolean> = this.#open;
  /**
   * The memory that is meant to fly: the one that was current when the timer was connected, or that the pilot has made
   * fly since. Null when that was not known before another one was selected.
   */
  readonly original: ReadonlySignal<number | null> = this.#original;
  /** The memory that flies next; null when that is not known. It need not be the one on the screen. */
  readonly memory: ReadonlySignal<number | null> = computed(() => (this.#open.value ? null : this.#current.value));
  /** The memory that was current when the timer was connected, if that is known. */
  readonly came: ReadonlySignal<number | null> = this.#came;
  /** Null while the memory of connecting flies next. It is no accident, so nothing warns of it. */
  readonly chosen: ReadonlySignal<ChosenFlight | null> = computed(() => {
    const memory = this.memory.value;
    const before = this.#came.value;
    return memory === null || memory !== this.#original.value || memory === before ? null : { memory, before };
  });
  /** What to warn the pilot of; null while the memory that is meant is current, or none was selected. */
  readonly word: ReadonlySignal<NextFlightWord | null> = computed(() => {
    const original = this.#original.value;
    const current = this.memory.value;
    if (current === original && current !== null) return null;
    if (current !== null) return { code: 'other', memory: current, original };
    return this.#left.value ? { code: 'unknown', asked: this.#asked.value, original } : null;
  });
  #kind: string | null = null;

  /** A timer is connected. One of the same kind that comes back to the same connection counts as the same timer. */
  timerCame(identity: Identity, simulated: boolean): void {
    const kind = kindKey(identity, simulated);
    batch(() => {
      if (kind !== this.#kind) this.forget();
      this.#open.value = true;
    });
    this.#kind = kind;
  }

  /** Another memory is about to be selected; null when it is not known which. */
  leave(memory: number | null): void {
    batch(() => {
      this.#open.value = true;
      this.#left.value = true;
      this.#asked.value = memory;
    });
  }

  /** Until the next reading, another memory may be current, or the timer may hold something else. */
  doubt(): void {
    this.#open.value = true;
  }

  /**
   * The timer has told the current memory; null when it does not say.
   * @param isKnown whether it is the one from before, or the screen need not show it; else it is read first.
   */
  found(memory: number | null, isKnown = true): void {
    batch(() => {
      this.#open.value = !isKnown;
      this.#current.value = memory;
      if (memory === null) return;
      if (!this.#left.value) {
        this.#original.value ??= memory;
        this.#came.value ??= memory;
      }
      if (memory === this.#original.value) this.#left.value = false;
    });
  }

  /** The pilot has made this memory fly next. Counts only if the timer says so, too. */
  chose(memory: number): void {
    if (this.#open.peek() || this.#current.peek() !== memory) return;
    batch(() => {
      this.#original.value = memory;
      this.#left.value = false;
    });
  }

  /** The connection has ended. */
  forget(): void {
    batch(() => {
      this.#kind = null;
      this.#original.value = null;
      this.#came.value = null;
      this.#current.value = null;
      this.#left.value = false;
      this.#asked.value = null;
    });
  }
}
