import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import type { Identity } from '../../protocol/index.js';
import { kindKey } from './record-keys.js';

/** What the pilot must know about the memory that flies next. Memories count from 0. */
export type NextFlightWord =
  /**
   * The timer says that another memory is current than at connect. `original` is null when that one was never known.
   */
  | { readonly code: 'other'; readonly memory: number; readonly original: number | null }
  /** Others were selected, and it is not known which is current. `asked` was selected last, if that is known. */
  | { readonly code: 'unknown'; readonly asked: number | null; readonly original: number | null };

/**
 * The current memory is what flies next. Only selecting one (SETMEMORY) changes it. This page does so when the pilot
 * asks for it, or to read others and come back. So it remembers which memory was current at connect, and warns when
 * another one is.
 */
export class NextFlight {
  readonly #open = signal(false, { name: 'memoryOpen' });
  readonly #original = signal<number | null>(null, { name: 'original' });
  /** The memory that the timer last named. */
  readonly #current = signal<number | null>(null, { name: 'current' });
  /** Whether other memories were selected since the one of connecting was current. */
  readonly #left = signal(false, { name: 'left' });
  readonly #asked = signal<number | null>(null, { name: 'asked' });
  /**
   * Whether no memory was read since the timer came, or since another one was selected: the memory on the screen may
   * not be the current one.
   */
  readonly open: ReadonlySignal<boolean> = this.#open;
  /**
   * The memory that was current when the timer was connected;
   * null when that was not known before another one was selected.
   */
  readonly original: ReadonlySignal<number | null> = this.#original;
  /** What to tell the pilot; null while the memory of connecting is current, or none was selected. */
  readonly word: ReadonlySignal<NextFlightWord | null> = computed(() => {
    const original = this.#original.value;
    const current = this.#open.value ? null : this.#current.value;
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

  /**
   * Until the next reading, the memory on the screen may not be the current one, or the timer may hold something else.
   */
  doubt(): void {
    this.#open.value = true;
  }

  /**
   * The timer has told the current memory; null when it does not say.
   * @param onScreen whether it is the memory on the screen.
   */
  found(memory: number | null, onScreen = true): void {
    batch(() => {
      this.#open.value = !onScreen;
      this.#current.value = memory;
      if (memory === null) return;
      if (!this.#left.value) this.#original.value ??= memory;
      if (memory === this.#original.value) this.#left.value = false;
    });
  }

  /** The connection has ended. */
  forget(): void {
    batch(() => {
      this.#kind = null;
      this.#original.value = null;
      this.#current.value = null;
      this.#left.value = false;
      this.#asked.value = null;
    });
  }
}
