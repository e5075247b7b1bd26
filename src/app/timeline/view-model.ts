import { type ReadonlySignal, signal } from '@preact/signals';
import type { ProgramField } from '../../program/index.js';
import type { DragEdit } from './drag.js';
import type { TimeView } from './layout.js';
import type { Scale } from './scale.js';

const ALL: TimeView = { start: 0, span: 1 };
/** The deepest zoom: this many times the whole. */
const DEEPEST = 60;

/** A handle that is being moved. */
export interface Moving {
  readonly edit: DragEdit;
  /** The axis as it was when the handle was taken: it stands still until the handle is let go. */
  readonly scale: Scale;
}

/** A time of the flight in hundredths of a second, or a servo. */
export type SpokenPlace = { readonly time: number } | { readonly servo: number };

/**
 * What a pilot looks at in a timeline, and what is in hand. It belongs to the screen; nothing of it is in the program.
 */
export class TimelineModel {
  readonly #even = signal(false);
  readonly #asked = signal<number | null>(null);
  readonly #spoken = signal<SpokenPlace | null>(null);
  readonly #front = signal(0);
  readonly #moving = signal<Moving | null>(null);
  readonly #fineness = signal(0);
  readonly #pointed = signal<ProgramField | null>(null);
  readonly #entered = signal(false);
  readonly #wanted = signal<ProgramField | null>(null);
  readonly #view = signal<TimeView>(ALL);
  /** Whether every second has the same length. */
  readonly even: ReadonlySignal<boolean> = this.#even;
  /** The time that a pointer or a key has asked about, in hundredths of a second. */
  readonly asked: ReadonlySignal<number | null> = this.#asked;
  /** What a key has asked about or taken in hand: it is said to who does not see it. */
  readonly spoken: ReadonlySignal<SpokenPlace | null> = this.#spoken;
  /** The servo in hand: its lane is tall and has handles. */
  readonly front: ReadonlySignal<number> = this.#front;
  readonly moving: ReadonlySignal<Moving | null> = this.#moving;
  /** How finely the handle in hand is moved: 0 as far as the pointer, 1 as finely as can be. */
  readonly fineness: ReadonlySignal<number> = this.#fineness;
  /** What the mouse is over and could take hold of; null while something is in hand. */
  readonly pointed: ReadonlySignal<ProgramField | null> = this.#pointed;
  /** Whether the keyboard is among the handles. */
  readonly entered: ReadonlySignal<boolean> = this.#entered;
  /** The field whose handle shall have the focus as soon as it is there. */
  readonly wanted: ReadonlySignal<ProgramField | null> = this.#wanted;
  /** What is in view. */
  readonly view: ReadonlySignal<TimeView> = this.#view;

  get zoomed(): boolean {
    return this.#view.value.span < 1;
  }

  /** The picture goes away: nothing is asked about any more. What is in view stays for when it comes back. */
  leave(): void {
    this.askAloud(null);
    this.pointAt(null);
    this.#entered.value = false;
    this.#wanted.value = null;
  }

  /** Gives every second the same length, or room to where much happens; all is in view then. */
  setEven(even: boolean): void {
    this.#even.value = even;
    this.fit();
  }

  /** @param time in hundredths of a second; null for no time. */
  ask(time: number | null): void {
    this.#asked.value = time;
  }

  /** Asks about a time, and says it. */
  askAloud(time: number | null): void {
    this.#asked.value = time;
    this.#spoken.value = time === null ? null : { time };
  }

  bringToFront(servo: number): void {
    this.#front.value = servo;
  }

  /** Takes a servo in hand, and says it. */
  bringToFrontAloud(servo: number): void {
    this.#front.value = servo;
    this.#spoken.value = { servo };
  }

  pointAt(field: ProgramField | null): void {
    this.#pointed.value = field;
  }

  /** Takes a handle in hand. @param scale the axis as it is now. */
  take(edit: DragEdit, scale: Scale): void {
    const { field } = edit;
    this.#asked.value = null;
    if (field.kind === 'position') this.#front.value = field.servo;
    this.#wanted.value = field;
    this.#fineness.value = 0;
    this.#moving.value = { edit, scale };
  }

  /** The handle in hand is moved more or less finely from now on. */
  refine(fineness: number): void {
    this.#fineness.value = fineness;
  }

  /** Lets go of the handle. What is in view may have left the picture with it, and comes back. */
  letGo(): void {
    if (!this.#moving.peek()) return;
    this.#moving.value = null;
    this.settle();
  }

  /** The keyboard goes among the handles, or leaves them. */
  setEntered(entered: boolean): void {
    this.#entered.value = entered;
  }

  /** Wants the focus at the handle of a field; null once it is there. */
  want(field: ProgramField | null): void {
    this.#wanted.value = field;
  }

  /**
   * Shows less or more.
   * @param anchor the place of the scale that stays where it is, or comes into view; the middle of what is in view if
   * there is none.
   */
  zoom(factor: number, anchor?: number): void {
    const { start, span } = this.#view.peek();
    const fixed = anchor ?? start + span / 2;
    const share = fixed < start || fixed > start + span ? 0.5 : (fixed - start) / span;
    const next = Math.min(1, Math.max(1 / DEEPEST, span / factor));
    this.#show(fixed - share * next, next);
  }

  /**
   * Moves what is in view.
   * @param by a share of it, positive to later times.
   * @param past lets it leave the end of the picture.
   */
  pan(by: number, past = false): void {
    const { start, span } = this.#view.peek();
    if (past) this.#view.value = { start: Math.max(0, start + by * span), span };
    else this.#show(start + by * span, span);
  }

  /** Shows two places at given shares of what is in view. */
  hold(a: { place: number; share: number }, b: { place: number; share: number }): void {
    const span = Math.min(1, Math.max(1 / DEEPEST, (b.place - a.place) / (b.share - a.share)));
    const middle = (a.place + b.place) / 2;
    this.#show(middle - ((a.share + b.share) / 2) * span, span);
  }

  /** Shows all. */
  fit(): void {
    this.#view.value = ALL;
  }

  /** Brings a place of the scale into view, if it is not. */
  reveal(place: number): void {
    const { start, span } = this.#view.peek();
    if (place < start || place > start + span) this.#show(place - span / 2, span);
  }

  /** Puts what is in view back inside of the picture. */
  settle(): void {
    const { start, span } = this.#view.peek();
    this.#show(start, span);
  }

  #show(start: number, span: number): void {
    this.#view.value = span >= 1 ? ALL : { start: Math.min(1 - span, Math.max(0, start)), span };
  }
}
