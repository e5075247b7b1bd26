import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { slotCount } from '../../protocol/index.js';
import type { Editor } from '../editing/editor.js';

/**
 * Where the motor stop of a Q stands among the rows: in the order of time. A function at the same time comes after it,
 * because it moves with the motor stop.
 */
export class MotorPlace {
  readonly #held = signal<number | null>(null);
  readonly #due: ReadonlySignal<number | null>;
  /** The slot before whose row it stands; one more than the last slot when it comes after DT. Null on other classes. */
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
