/** So many milliseconds a key is held before it repeats itself, and between one time and the next. */
const BEFORE = 450;
const BETWEEN = 90;

/** A key that does something once when it is pressed, and again and again while it is held. */
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

  /** The key was let go, or the finger has left it. */
  release(): void {
    clearTimeout(this.#timer);
  }

  /** The press counts as one, also without a finger; one that has repeated itself is over. */
  click(work: () => void): void {
    this.release();
    if (!this.#repeated) work();
    this.#repeated = false;
  }
}
