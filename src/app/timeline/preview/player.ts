import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
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

/**
 * A flight that is played: a time that runs from launch to a few seconds after the last event. Until it is played or
 * gone through it shows what the pilot has in hand, and what is asked about at any time.
 */
export class Player {
  readonly #time = signal(0);
  readonly #playing = signal(false);
  readonly #speed = signal<Speed>(1);
  readonly #end = signal(RUN_OUT);
  /** Somebody plays it, or has gone to a time of it: it stays there. */
  readonly #underWay = signal(false);
  readonly #inHand = signal(0);
  readonly #asked = signal<number | null>(null);
  /** What is to be shown, in hundredths of a second from launch. */
  readonly shown: ReadonlySignal<number> = computed(
    () =>
      this.#asked.value ?? (this.#underWay.value ? this.#time.value : Math.min(this.#end.value, this.#inHand.value)),
  );
  /** Where the flight is, to be marked on a timeline; null until it is under way. */
  readonly cursor: ReadonlySignal<number | null> = computed(() => (this.#underWay.value ? this.#time.value : null));
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

  /** The pilot has something of this time in hand: a flight that is played goes on, one that stands gives way to it. */
  take(time: number): void {
    batch(() => {
      this.#inHand.value = drawable(time);
      if (!this.#playing.peek()) this.#underWay.value = false;
    });
  }

  /** Shows a time for as long as somebody asks about it; null for no longer. */
  ask(time: number | null): void {
    this.#asked.value = time === null ? null : drawable(time);
  }

  /** Goes on, else begins with what is in hand; from the end it starts again at launch. */
  play(): void {
    if (this.#playing.peek()) return;
    batch(() => {
      if (!this.#underWay.peek()) this.#begin();
      if (this.#exact >= this.#end.peek()) this.#goTo(0);
      this.#underWay.value = true;
      this.#playing.value = true;
    });
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
    batch(() => {
      this.#underWay.value = true;
      this.#goTo(Math.min(this.#end.peek(), drawable(time)));
    });
  }

  setSpeed(speed: Speed): void {
    this.#speed.value = speed;
  }

  /** From what is in hand; but behind the last event there is nothing to be seen. */
  #begin(): void {
    const inHand = this.#inHand.peek();
    this.#goTo(inHand < this.#end.peek() - RUN_OUT ? inHand : 0);
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
