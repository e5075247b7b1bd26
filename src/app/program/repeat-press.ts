/** How long a key is held before it repeats, and the time between repeats, in milliseconds. */
const BEFORE = 450;
const BETWEEN = 90;

/** A key that acts once when it is pressed, and repeatedly while it is held. */
export class RepeatPress {
  #timer: ReturnType<typeof setTimeout> | undefined;
  #repeated = false;

  /** The key went down. */
  press(work: () => void): void {
    this.release();
    this.#repeated = false;
    const again = (): void => {
      this.#repeated = true;
      work();
      this.#timer = setTimeout(again, BETWEEN);
    };
    this.#timer = setTimeout(again, BEFORE);
  }

  /** The key was released, or the finger has left it. */
  release(): void {
    clearTimeout(this.#timer);
  }

  /** A click counts as one press, also without a pointer. A press that has repeated itself does not count again. */
  click(work: () => void): void {
    this.release();
    if (!this.#repeated) work();
    this.#repeated = false;
  }
}
