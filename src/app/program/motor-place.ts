import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { slotCount } from '../../protocol/index.js';
import type { Editor } from '../editing/editor.js';

/**
 * Where the motor stop of a Q stands among the rows: in the order of time. A function at its very time comes after it,
 * for it goes along when the motor stop is shifted.
 */
export class MotorPlace {
  readonly #held = signal<number | null>(null);
  readonly #due: ReadonlySignal<number | null>;
  /** The slot before whose row it stands, one more than the last where it comes after DT; null on other classes. */
  readonly before: ReadonlySignal<number | null>;

  constructor({ identity, working }: Editor) {
    this.#due = computed(() => {
      const { value: program } = working;
      if (!program || identity.value?.timerClass !== 'Q') return null;
      const [stop = 0] = program.times;
      const next = program.times.findIndex((time, slot) => slot > 0 && time >= stop);
      return next < 0 ? slotCount(program.identity) : next;
    });
    this.before = computed(() => (this.#due.value === null ? null : (this.#held.value ?? this.#due.value)));
  }

  /** From here on nothing moves under the finger, until this is called again or it is released. */
  hold(): void {
    this.#held.value = this.#due.value;
  }

  /** As it stands now, also where it is held already. */
  keep(): void {
    this.#held.value = this.before.value;
  }

  release(): void {
    this.#held.value = null;
  }
}
