import { type ReadonlySignal, signal } from '@preact/signals';

/** So many milliseconds a button has to be held before it does what it says. */
export const HOLD = 1200;

/** Something that happens only when a button is pressed and held: once for each hold, however long that lasts. */
export class PressAndHold {
  readonly #holding = signal(false);
  readonly #done: () => void;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #pressed = false;

  constructor(done: () => void) {
    this.#done = done;
  }

  /** Whether it is being held and has not happened yet. */
  get holding(): ReadonlySignal<boolean> {
    return this.#holding;
  }

  /** The button went down. A key that repeats itself while it is down counts once. */
  press(): void {
    if (this.#pressed) return;
    this.#pressed = true;
    this.#holding.value = true;
    this.#timer = setTimeout(() => {
      this.#holding.value = false;
      this.#done();
    }, HOLD);
  }

  /** The button was let go, or the finger has left it. */
  release(): void {
    clearTimeout(this.#timer);
    this.#pressed = false;
    this.#holding.value = false;
  }
}
