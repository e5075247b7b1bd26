import { vi } from 'vitest';

/** Frames of the screen that come when they are told to, in place of its own until the test ends. */
export class HandFrames {
  now = 1000;
  readonly #waiting = new Map<number, FrameRequestCallback>();
  #last = 0;

  constructor() {
    vi.stubGlobal('requestAnimationFrame', (callback: FrameRequestCallback) => {
      this.#waiting.set(++this.#last, callback);
      return this.#last;
    });
    vi.stubGlobal('cancelAnimationFrame', (id: number) => this.#waiting.delete(id));
  }

  get waiting(): number {
    return this.#waiting.size;
  }

  /** So many frames, each some milliseconds after the one before. */
  run(count: number, ms: number): void {
    for (let i = 0; i < count; i++) {
      this.now += ms;
      const due = [...this.#waiting.values()];
      this.#waiting.clear();
      for (const callback of due) callback(this.now);
    }
  }
}
