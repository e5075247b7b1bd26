import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import { drawable, RUN_OUT } from '../scale.js';

/** How many times faster than real time. */
export const SPEEDS = [1, 5, 20] as const;
export type Speed = (typeof SPEEDS)[number];

/** The most milliseconds that count between two frames: a page that was hidden goes on where it was. */
const LONGEST_FRAME = 250;
/** Hundredths of a second in a millisecond. */
const UNITS = 0.1;

/**
 * Plays a flight: a time that runs from launch to a few seconds after the last event. Before it is played, it shows the
 * time that the pilot has selected, or asks about.
 */
export class Player {
  // Only this player writes them.
  readonly playing = signal(false);
  readonly speed = signal<Speed>(1);
  /**
   * The place of the flight, in whole hundredths of a second from launch, to mark on a timeline; null until it was
   * played or sought. It then stays there.
   */
  readonly cursor = signal<number | null>(null);
  readonly #end = signal(RUN_OUT);
  readonly #inHand = signal(0);
  /** The time to show, in hundredths of a second from launch. */
  readonly shown: ReadonlySignal<number>;
  /** Not rounded, so that slow frames lose nothing. */
  #exact = 0;
  #frame = 0;

  /** @param asked a time that somebody asks about: it is shown as long as it is not null. */
  constructor(asked?: ReadonlySignal<number | null>) {
    this.shown = computed(() => {
      const time = asked?.value ?? null;
      if (time !== null) return drawable(time);
      return this.cursor.value ?? Math.min(this.#end.value, this.#inHand.value);
    });
  }

  /** Another program is shown. A time past its end becomes its end. */
  setEnd(end: number): void {
    this.#end.value = drawable(end);
    if (this.cursor.peek() !== null) this.#goTo(this.#exact);
  }

  /** The pilot has selected something at this time. A playing flight goes on; a paused one goes there. */
  take(time: number): void {
    batch(() => {
      this.#inHand.value = drawable(time);
      if (!this.playing.peek()) this.cursor.value = null;
    });
  }

  /** Pauses, or goes on. The first time it begins at the selected time; from the end it begins at launch again. */
  toggle(): void {
    if (this.playing.peek()) {
      this.pause();
      return;
    }
    const last = this.#end.peek() - RUN_OUT;
    batch(() => {
      if (this.cursor.peek() === null) this.#goTo(this.#inHand.peek() < last ? this.#inHand.peek() : 0);
      else if (this.#exact >= this.#end.peek()) this.#goTo(0);
      this.playing.value = true;
    });
    this.#await(null);
  }

  pause(): void {
    this.playing.value = false;
    cancelAnimationFrame(this.#frame);
  }

  /** Goes to a time, playing or not. */
  seek(time: number): void {
    this.#goTo(drawable(time));
  }

  setSpeed(speed: Speed): void {
    this.speed.value = speed;
  }

  #await(before: number | null): void {
    this.#frame = requestAnimationFrame((now) => {
      const passed = before === null ? 0 : Math.min(LONGEST_FRAME, now - before);
      this.#goTo(this.#exact + passed * UNITS * this.speed.peek());
      if (this.#exact >= this.#end.peek()) this.playing.value = false;
      else this.#await(now);
    });
  }

  #goTo(time: number): void {
    this.#exact = Math.min(this.#end.peek(), time);
    this.cursor.value = Math.floor(this.#exact);
  }
}
