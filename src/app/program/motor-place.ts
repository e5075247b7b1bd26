import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { Editor } from '../editing/editor.js';
import { motorRow } from '../editing/grid.js';

/** Where the motor stop of a Q stands among the rows. */
export class MotorPlace {
  readonly #held = signal<number | null>(null);
  readonly #due: ReadonlySignal<number | null>;
  /** The slot before whose row it stands: see {@link motorRow}. */
  readonly before: ReadonlySignal<number | null>;

  constructor({ working }: Editor) {
    this.#due = computed(() => working.value && motorRow(working.value));
    this.before = computed(() => (this.#due.value === null ? null : (this.#held.value ?? this.#due.value)));
  }

  /** Holds the place, so that nothing moves under the finger, until the next call or a release. */
  hold(): void {
    this.#held.value = this.#due.value;
  }

  /** Holds the present place, even if another one is held. */
  keep(): void {
    this.#held.value = this.before.value;
  }

  release(): void {
    this.#held.value = null;
  }
}
