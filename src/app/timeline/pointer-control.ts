import type { CellField } from '../editing/grid.js';
import { DragEdit, type Shown } from './drag.js';
import { focusHandle } from './key-control.js';
import { MoveHandle } from './move-handle.js';
import { fieldUnder, type Point, servoUnder, timeUnder } from './under-pointer.js';
import type { TimelineModel } from './view-model.js';

/** How far a tapping finger may tremble on a handle, in pixels. */
const TREMBLE = 5;
/** Beside the handles a smaller movement counts as standing still, in pixels. */
const STILL = 4;

/** A pointer that is down: on a handle, or beside them, where it asks for the time or moves the view. */
interface Held {
  readonly id: number;
  readonly handle: MoveHandle | null;
  readonly from: Point;
  /** Whether the picture is larger than the view. */
  readonly pans: boolean;
  last: Point;
  moved: boolean;
}

/** Mouse, pen and finger on a timeline: one at a time. */
export class PointerControl {
  readonly #model: TimelineModel;
  readonly #shown: () => Shown | null;
  #held: Held | null = null;

  constructor(model: TimelineModel, shown: () => Shown | null) {
    this.#model = model;
    this.#shown = shown;
  }

  readonly down = (event: PointerEvent): void => {
    const shown = this.#shown();
    if (!shown || this.#held || event.button > 0) return;
    const { svg, geometry, now, onEdit } = shown;
    const from = pointIn(svg, event);
    const field = fieldFor(shown, event, from);
    const layout = () => (this.#shown()?.geometry ?? geometry).layout;
    const handle =
      field && onEdit
        ? new MoveHandle(this.#model, new DragEdit(now, field, onEdit), from, layout, isFinger(event) ? TREMBLE : 0)
        : null;
    this.#held = { id: event.pointerId, handle, from, pans: this.#model.zoomed, last: from, moved: false };
    this.#model.pointAt(null);
    if (field) focusHandle(svg, field);
    else this.#look(this.#held, shown, from);
    svg.setPointerCapture?.(event.pointerId);
    window.addEventListener('keydown', this.#key, { capture: true });
  };

  /** A finger on a handle does not scroll the page; one beside the handles does. Comes after {@link down}. */
  readonly touch = (event: TouchEvent): void => {
    if (this.#held?.handle) event.preventDefault();
  };

  readonly move = (event: PointerEvent): void => {
    const shown = this.#shown();
    if (!shown) return;
    if (!this.#held) this.#hover(shown, event);
    else if (event.pointerId !== this.#held.id) return;
    // The button was released where the page could not hear it, as over another window or with another button down.
    else if ((event.buttons & 1) === 0) this.cancel();
    else if (this.#held.handle) this.#held.handle.move(pointIn(shown.svg, event));
    else this.#look(this.#held, shown, pointIn(shown.svg, event));
  };

  readonly up = (event: PointerEvent): void => {
    const shown = this.#shown();
    const held = this.#held;
    if (event.pointerId !== held?.id || !shown) return;
    const point = pointIn(shown.svg, event);
    if (held.handle) held.handle.end(point);
    else this.#look(held, shown, point);
    const servo = held.handle || held.moved ? null : servoUnder(shown.geometry, held.from.y);
    if (servo !== null) this.#model.bringToFront(servo);
    this.#end();
  };

  /** The browser uses the finger to scroll the page, so it was not meant for the picture. */
  readonly lost = (event: PointerEvent): void => {
    if (event.pointerId === this.#held?.id) this.cancel();
  };

  readonly leave = (event: PointerEvent): void => {
    if (isFinger(event) || this.#held) return;
    this.#model.ask(null);
    this.#model.pointAt(null);
  };

  /** Releases everything and puts back what was being moved. */
  readonly cancel = (): void => {
    this.#held?.handle?.end(null);
    this.#end();
  };

  /** Down beside the handles: asks for the time, or moves the view. */
  #look(held: Held, { geometry }: Shown, point: Point): void {
    held.moved ||= Math.abs(point.x - held.from.x) > STILL;
    if (held.pans && held.moved) {
      this.#model.pan((held.last.x - point.x) / geometry.layout.width);
      held.last = point;
    } else this.#model.ask(timeUnder(geometry, point.x));
  }

  /** The mouse passes over: asks for the time, and shows by its shape what it could take. */
  #hover(shown: Shown, event: PointerEvent): void {
    if (isFinger(event)) return;
    const point = pointIn(shown.svg, event);
    const field = fieldFor(shown, event, point);
    shown.svg.setAttribute('data-over', field?.kind ?? '');
    this.#model.pointAt(field);
    this.#model.ask(timeUnder(shown.geometry, point.x));
  }

  readonly #key = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape' || !this.#held?.handle) return;
    event.preventDefault();
    event.stopPropagation();
    this.cancel();
  };

  #end(): void {
    this.#held = null;
    window.removeEventListener('keydown', this.#key, { capture: true });
  }
}

/** The field that a pointer would take; null where nothing can be changed. */
function fieldFor({ geometry, onEdit }: Shown, event: PointerEvent, point: Point): CellField | null {
  return onEdit ? fieldUnder(geometry, point, isFinger(event)) : null;
}

function isFinger({ pointerType }: PointerEvent): boolean {
  return pointerType === 'touch';
}

function pointIn(svg: SVGSVGElement, event: MouseEvent): Point {
  const { left, top } = svg.getBoundingClientRect();
  return { x: event.clientX - left, y: event.clientY - top };
}
