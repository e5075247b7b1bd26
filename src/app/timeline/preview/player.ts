import { type ReadonlySignal, signal } from '@preact/signals';
import { drawable, RUN_OUT } from '../scale.js';

/** What turns the player's clock: the frames of the screen, or a test. */
export interface Frames {
  /**
   * Calls back once, at the next frame, with a time in milliseconds that never runs backwards.
   * @returns a function that takes it back.
   */
  next(callback: (now: number) => void): () => void;
}

/** The frames of the screen. They stop while the page is hidden. */
export const screenFrames: Frames = {
  next(callback) {
    const id = requestAnimationFrame(callback);
    return () => cancelAnimationFrame(id);
  },
};

/** How many times faster than the flight. */
export const SPEEDS = [1, 2, 5, 10, 60] as const;
export type Speed = (typeof SPEEDS)[number];

/** Between two frames no more time passes than this, in milliseconds: a page that was hidden goes on where it was. */
const LONGEST_FRAME = 250;
/** Hundredths of a second in a millisecond. */
const UNITS = 0.1;

/** A flight that is played: a time that runs from launch to a few seconds after the last event. */
export class Player {
  readonly #time = signal(0);
  readonly #playing = signal(false);
  readonly #speed = signal<Speed>(1);
  readonly #end = signal(RUN_OUT);
  readonly #frames: Frames;
  /** Not rounded, so that slow frames do not lose any of it. */
  #exact = 0;
  #stop: (() => void) | null = null;

  constructor(frames: Frames = screenFrames) {
    this.#frames = frames;
  }

  /** Hundredths of a second from launch, whole. */
  get time(): ReadonlySignal<number> {
    return this.#time;
  }

  get playing(): ReadonlySignal<boolean> {
    return this.#playing;
  }

  get speed(): ReadonlySignal<Speed> {
    return this.#speed;
  }

  /** Where the flight ends, in hundredths of a second. */
  get end(): ReadonlySignal<number> {
    return this.#end;
  }

  /** Another program is shown. A time past its end becomes its end. */
  setEnd(end: number): void {
    this.#end.value = drawable(end);
    if (this.#exact > this.#end.value) this.#goTo(this.#end.value);
  }

  /** Goes on, or from the end starts again at launch. */
  play(): void {
    if (this.#playing.peek()) return;
    if (this.#exact >= this.#end.peek()) this.#goTo(0);
    this.#playing.value = true;
    this.#await(null);
  }

  pause(): void {
    this.#playing.value = false;
    this.#stop?.();
    this.#stop = null;
  }

  toggle(): void {
    if (this.#playing.peek()) this.pause();
    else this.play();
  }

  /** Goes to a time, playing or not. */
  seek(time: number): void {
    this.#goTo(Math.min(this.#end.peek(), drawable(time)));
  }

  setSpeed(speed: Speed): void {
    this.#speed.value = speed;
  }

  #await(before: number | null): void {
    this.#stop = this.#frames.next((now) => {
      this.#stop = null;
      const passed = before === null ? 0 : Math.min(LONGEST_FRAME, now - before);
      this.#goTo(Math.min(this.#end.peek(), this.#exact + passed * UNITS * this.#speed.peek()));
      if (this.#exact >= this.#end.peek()) this.#playing.value = false;
      // Whoever follows the time may have paused it, or started it afresh.
      if (this.#playing.peek() && !this.#stop) this.#await(now);
    });
  }

  #goTo(time: number): void {
    this.#exact = time;
    this.#time.value = Math.floor(time);
  }
}
