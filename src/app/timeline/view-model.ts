import { signal } from '@preact/signals';
import type { ProgramField } from '../../program/index.js';
import type { DragEdit } from './drag.js';
import { type TimeView, WHOLE } from './layout.js';
import type { Scale } from './scale.js';

/** The deepest zoom, as a multiple of the whole. */
const DEEPEST = 60;

/** A handle that is being moved. */
export interface Moving {
  readonly edit: DragEdit;
  /** The axis when the handle was taken. It stands still until the handle is released. */
  readonly scale: Scale;
  /** Whether it moves less than the pointer. */
  readonly finer: boolean;
}

/** A time of the flight in hundredths of a second, or a servo. */
export type SpokenPlace = { readonly time: number } | { readonly servo: number };

/** What a pilot looks at in a timeline, and the handle that is held. It belongs to the screen, not to the program. */
export class TimelineModel {
  // Only this model writes them.
  /** The time that a pointer or a key asks about, in hundredths of a second. */
  readonly asked = signal<number | null>(null);
  /** What a key has asked about or selected, for screen readers. */
  readonly spoken = signal<SpokenPlace | null>(null);
  /** The selected servo, whose lane is tall and has handles. */
  readonly front = signal(0);
  readonly moving = signal<Moving | null>(null);
  /** The field under the mouse that it could take; null while a handle is held. */
  readonly pointed = signal<ProgramField | null>(null);
  /** Whether the keyboard focus is on a handle. */
  readonly entered = signal(false);
  /** The part in view. */
  readonly view = signal<TimeView>(WHOLE);

  get zoomed(): boolean {
    return this.view.value.span < 1;
  }

  /** The picture goes away: nothing is asked about any more. The view stays for when it comes back. */
  leave(): void {
    this.tell(null);
    this.pointAt(null);
    this.entered.value = false;
  }

  /** @param time in hundredths of a second; null for no time. */
  ask(time: number | null): void {
    this.asked.value = time;
  }

  /** Asks about a time or selects a servo, and tells screen readers; null asks about no time any more. */
  tell(place: SpokenPlace | null): void {
    this.spoken.value = place;
    if (place && 'servo' in place) this.bringToFront(place.servo);
    else this.ask(place?.time ?? null);
  }

  bringToFront(servo: number): void {
    this.front.value = servo;
  }

  pointAt(field: ProgramField | null): void {
    this.pointed.value = field;
  }

  /** Takes a handle. @param scale the present axis. */
  take(edit: DragEdit, scale: Scale): void {
    this.ask(null);
    if (edit.field.kind === 'position') this.bringToFront(edit.field.servo);
    this.moving.value = { edit, scale, finer: false };
  }

  /** Whether the held handle moves less than the pointer. */
  refine(finer: boolean): void {
    const moving = this.moving.peek();
    if (moving && moving.finer !== finer) this.moving.value = { ...moving, finer };
  }

  /** Releases the handle. The view may have left the picture with it, and comes back. */
  letGo(): void {
    if (!this.moving.peek()) return;
    this.moving.value = null;
    this.pan(0);
  }

  /** The keyboard focus goes to the handles, or leaves them. */
  setEntered(entered: boolean): void {
    this.entered.value = entered;
  }

  /**
   * Shows less or more.
   * @param anchor the place of the scale that stays where it is, or comes into view. Default: the middle of the view.
   */
  zoom(factor: number, anchor?: number): void {
    const { start, span } = this.view.peek();
    const fixed = anchor ?? start + span / 2;
    const share = fixed < start || fixed > start + span ? 0.5 : (fixed - start) / span;
    const next = Math.min(1, Math.max(1 / DEEPEST, span / factor));
    this.#show(fixed - share * next, next);
  }

  /**
   * Moves the view.
   * @param by a share of it, positive to later times.
   * @param past lets it pass the end of the picture.
   */
  pan(by: number, past = false): void {
    const { start, span } = this.view.peek();
    if (past) this.view.value = { start: Math.max(0, start + by * span), span };
    else this.#show(start + by * span, span);
  }

  /** Shows everything. */
  fit(): void {
    this.view.value = WHOLE;
  }

  /** Brings a place of the scale into view. */
  reveal(place: number): void {
    const { start, span } = this.view.peek();
    if (place < start || place > start + span) this.#show(place - span / 2, span);
  }

  #show(start: number, span: number): void {
    this.view.value = span >= 1 ? WHOLE : { start: Math.min(1 - span, Math.max(0, start)), span };
  }
}
