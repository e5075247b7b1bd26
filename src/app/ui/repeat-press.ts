import type { ReadonlySignal } from '@preact/signals';

/** How long a key is held before it repeats, and the time between repeats, in milliseconds. */
const BEFORE = 450;
const BETWEEN = 90;

/** What a key does. @param isFirst whether it is the first time in this press. */
type Work = (isFirst: boolean) => void;

/** A key that acts once when it is pressed, and repeatedly while it is held. */
export class RepeatPress {
  readonly #isBehind: ReadonlySignal<boolean> | undefined;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #unwatch = (): void => {};
  #isDown = false;
  #repeated = false;

  /** @param isBehind whether what it did before is still on its way: a held key waits for that. */
  constructor(isBehind?: ReadonlySignal<boolean>) {
    this.#isBehind = isBehind;
  }

  /** The key went down. */
  press(work: Work): void {
    this.release();
    this.#isDown = true;
    this.#repeated = false;
    const again = (): void => {
      const isFirst = !this.#repeated;
      this.#repeated = true;
      work(isFirst);
      // The work itself may have taken the key away.
      if (this.#isDown) this.#timer = setTimeout(due, BETWEEN);
    };
    const goOn = (isBehind: boolean): void => {
      if (isBehind) return;
      this.#unwatch();
      // By then the key is gone, if what it moves has ended.
      this.#timer = setTimeout(due);
    };
    const due = (): void => {
      if (this.#isBehind?.peek()) this.#unwatch = this.#isBehind.subscribe(goOn);
      else again();
    };
    this.#timer = setTimeout(due, BEFORE);
  }

  /** The key was released, or the finger has left it. */
  release(): void {
    clearTimeout(this.#timer);
    this.#unwatch();
    this.#isDown = false;
  }

  /** A click counts as one press, also without a pointer. A press that has repeated itself does not count again. */
  click(work: Work): void {
    this.release();
    if (!this.#repeated) work(true);
    this.#repeated = false;
  }

  /** Space or Enter was released: a click, if it went down here. */
  lift(work: Work): void {
    if (this.#isDown) this.click(work);
  }
}
