import { type ReadonlySignal, signal } from '@preact/signals';

/** How long a button has to be held before it acts, in milliseconds. */
export const HOLD = 1200;
/** When the time is over so much too late, the page stood still: that it was released may not be heard yet. */
const LATE = 100;

/** An act that needs a button to be pressed and held: once for each hold, however long it lasts. */
export class PressAndHold {
  readonly #holding = signal(false);
  /** Whether it is being held and has not acted yet. */
  readonly holding: ReadonlySignal<boolean> = this.#holding;
  readonly #done: () => void;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #pressed = false;

  constructor(done: () => void) {
    this.#done = done;
  }

  /** The button went down. A repeating key counts once. */
  press(): void {
    if (this.#pressed) return;
    this.#pressed = true;
    this.#holding.value = true;
    this.#await(HOLD);
  }

  #await(ms: number): void {
    const due = performance.now() + ms;
    this.#timer = setTimeout(() => {
      if (performance.now() > due + LATE) return this.#await(LATE);
      this.#holding.value = false;
      this.#done();
    }, ms);
  }

  /** The button was released, or the finger has left it. */
  release(): void {
    clearTimeout(this.#timer);
    this.#pressed = false;
    this.#holding.value = false;
  }
}
