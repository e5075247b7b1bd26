import type { TimerProgram } from '../../../program/index.js';
import type { OnEdit } from '../drag.js';
import type { Geometry } from '../geometry.js';
import { focusHandle } from '../key-control.js';
import type { TimelineModel } from '../view-model.js';
import { Look } from './look.js';
import { MoveHandle } from './move-handle.js';
import { fieldUnder, type Point, timeUnder } from './under-pointer.js';

/** What the pointer works on, as last drawn. */
export interface Target {
  readonly svg: SVGSVGElement;
  readonly geometry: Geometry;
  /** Gives the present program. */
  readonly now: () => TimerProgram;
  /** Absent when nothing can be changed. */
  readonly onEdit: OnEdit | undefined;
}

/** What a pressed pointer does. */
export interface Gesture {
  move(geometry: Geometry, point: Point): void;
  /** The pointer was released. */
  up(geometry: Geometry, point: Point): void;
  /** It was not meant: puts back what it changed. */
  cancel(): void;
}

/** Mouse, pen and finger on a timeline: one at a time. */
export class PointerControl {
  readonly #model: TimelineModel;
  readonly #target: () => Target | null;
  #held: { readonly id: number; readonly gesture: Gesture } | null = null;

  constructor(model: TimelineModel, target: () => Target | null) {
    this.#model = model;
    this.#target = target;
  }

  readonly down = (event: PointerEvent): void => {
    const target = this.#target();
    if (!target || this.#held || event.button > 0) return;
    const { svg, geometry, now, onEdit } = target;
    const from = pointIn(svg, event);
    const field = fieldUnder(target, this.#model.front.value, from, isFinger(event));
    const gesture =
      field && onEdit
        ? new MoveHandle(
            this.#model,
            { field, from, now, onEdit },
            () => this.#target()?.geometry ?? geometry,
            isFinger(event),
          )
        : new Look(this.#model, geometry, from);
    this.#held = { id: event.pointerId, gesture };
    this.#model.pointAt(null);
    if (field && onEdit) focusHandle(svg, field);
    svg.setPointerCapture?.(event.pointerId);
    window.addEventListener('keydown', this.#key, { capture: true });
  };

  /** A finger on a handle does not scroll the page; one beside the handles does. Comes after {@link down}. */
  readonly touch = (event: TouchEvent): void => {
    if (this.#model.moving.peek()) event.preventDefault();
  };

  readonly move = (event: PointerEvent): void => {
    const target = this.#target();
    if (!target) return;
    if (!this.#held) this.#hover(target, event);
    else if (event.pointerId !== this.#held.id) return;
    // The button was released where the page could not hear it, as over another window or with another button down.
    else if ((event.buttons & 1) === 0) this.cancel();
    else this.#held.gesture.move(target.geometry, pointIn(target.svg, event));
  };

  readonly up = (event: PointerEvent): void => {
    const target = this.#target();
    if (event.pointerId !== this.#held?.id || !target) return;
    this.#held.gesture.up(target.geometry, pointIn(target.svg, event));
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
    this.#held?.gesture.cancel();
    this.#end();
  };

  /** The mouse passes over: asks for the time, and shows by its shape what it could take. */
  #hover(target: Target, event: PointerEvent): void {
    if (isFinger(event)) return;
    const point = pointIn(target.svg, event);
    const field = fieldUnder(target, this.#model.front.value, point, false);
    target.svg.setAttribute('data-over', field?.kind ?? '');
    this.#model.pointAt(field);
    this.#model.ask(timeUnder(target.geometry, point.x));
  }

  readonly #key = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape' || !this.#model.moving.peek()) return;
    event.preventDefault();
    event.stopPropagation();
    this.cancel();
  };

  #end(): void {
    this.#held = null;
    window.removeEventListener('keydown', this.#key, { capture: true });
  }
}

function isFinger({ pointerType }: PointerEvent): boolean {
  return pointerType === 'touch';
}

function pointIn(svg: SVGSVGElement, event: MouseEvent): Point {
  const { left, top } = svg.getBoundingClientRect();
  return { x: event.clientX - left, y: event.clientY - top };
}
