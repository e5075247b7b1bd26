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
  /** Whole hundredths of a second from launch. */
  readonly time = signal(0);
  readonly playing = signal(false);
  readonly speed = signal<Speed>(1);
  readonly #end = signal(RUN_OUT);
  /** Whether the flight was played or sought: it then stays at that time. */
  readonly #underWay = signal(false);
  readonly #inHand = signal(0);
  /** The time to show, in hundredths of a second from launch. */
  readonly shown: ReadonlySignal<number>;
  /** The place of the flight, to mark on a timeline; null until it was played or sought. */
  readonly cursor: ReadonlySignal<number | null> = computed(() => (this.#underWay.value ? this.time.value : null));
  /** Not rounded, so that slow frames lose nothing. */
  #exact = 0;
  #frame = 0;

  /** @param asked a time that somebody asks about: it is shown as long as it is not null. */
  constructor(asked?: ReadonlySignal<number | null>) {
    this.shown = computed(() => {
      const time = asked?.value ?? null;
      if (time !== null) return drawable(time);
      return this.#underWay.value ? this.time.value : Math.min(this.#end.value, this.#inHand.value);
    });
  }

  /** Another program is shown. A time past its end becomes its end. */
  setEnd(end: number): void {
    this.#end.value = drawable(end);
    if (this.#exact > this.#end.value) this.#goTo(this.#end.value);
  }

  /** The pilot has selected something at this time. A playing flight goes on; a paused one goes there. */
  take(time: number): void {
    batch(() => {
      this.#inHand.value = drawable(time);
      if (!this.playing.peek()) this.#underWay.value = false;
    });
  }

  /** Goes on playing. The first time it begins at the selected time; from the end it begins at launch again. */
  play(): void {
    if (this.playing.peek()) return;
    batch(() => {
      if (!this.#underWay.peek()) this.#begin();
      if (this.#exact >= this.#end.peek()) this.#goTo(0);
      this.#underWay.value = true;
      this.playing.value = true;
    });
    this.#await(null);
  }

  pause(): void {
    this.playing.value = false;
    cancelAnimationFrame(this.#frame);
  }

  toggle(): void {
    if (this.playing.peek()) this.pause();
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
    this.speed.value = speed;
  }

  /** Begins at the selected time, unless that is after the last event. */
  #begin(): void {
    const inHand = this.#inHand.peek();
    this.#goTo(inHand < this.#end.peek() - RUN_OUT ? inHand : 0);
  }

  #await(before: number | null): void {
    this.#frame = requestAnimationFrame((now) => {
      this.#frame = 0;
      const passed = before === null ? 0 : Math.min(LONGEST_FRAME, now - before);
      this.#goTo(Math.min(this.#end.peek(), this.#exact + passed * UNITS * this.speed.peek()));
      if (this.#exact >= this.#end.peek()) this.playing.value = false;
      // A listener of the time may have paused or restarted it.
      if (this.playing.peek() && this.#frame === 0) this.#await(now);
    });
  }

  #goTo(time: number): void {
    this.#exact = time;
    this.time.value = Math.floor(time);
  }
}
