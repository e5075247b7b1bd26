import { type ProgramField, type TimerProgram, valueAt } from '../../../program/index.js';
import { stepSize } from '../../editing/edit.js';
import { DragEdit, limitsOf, type OnEdit, snapped } from '../drag.js';
import type { Geometry } from '../geometry.js';
import type { Layout } from '../layout.js';
import type { TimelineModel } from '../view-model.js';
import { isFine, refined } from './fineness.js';
import type { Gesture } from './pointer-control.js';
import type { Point } from './under-pointer.js';

/** Outside of the plot the picture follows the handle, in each frame by this share of the distance. */
const FOLLOW = 0.02;

/** How far a tapping finger may tremble, in pixels. */
const TREMBLE = 5;

interface Taken {
  readonly field: ProgramField;
  readonly from: Point;
  /** Gives the present program. */
  readonly now: () => TimerProgram;
  readonly onEdit: OnEdit;
}

/** A handle is held and moves its value. Far from where it took the handle, the pointer moves it finely. */
export class MoveHandle implements Gesture {
  readonly #model: TimelineModel;
  readonly #edit: DragEdit;
  readonly #from: Point;
  readonly #drawn: () => Geometry;
  /** How far the pointer may tremble, in pixels. */
  readonly #tremble: number;
  /** The last reported place of the pointer, along the way of the handle. */
  #last: number;
  /** Where the handle would be without steps and limits, along its way, in pixels. */
  #at: number;
  #moved = false;
  #frame = 0;

  /** @param drawn gives the picture as last drawn. */
  constructor(model: TimelineModel, { field, from, now, onEdit }: Taken, drawn: () => Geometry, isFinger: boolean) {
    const { layout } = drawn();
    this.#model = model;
    this.#edit = new DragEdit(now, field, onEdit);
    this.#from = from;
    this.#drawn = drawn;
    this.#tremble = isFinger ? TREMBLE : 0;
    this.#last = field.kind === 'time' ? from.x : from.y;
    this.#at = this.#placeOf(layout, valueAt(now(), field) ?? 0);
    model.take(this.#edit, layout.scale);
  }

  move({ layout }: Geometry, point: Point): void {
    cancelAnimationFrame(this.#frame);
    const { program, field } = this.#edit;
    const [along, across] = field.kind === 'time' ? (['x', 'y'] as const) : (['y', 'x'] as const);
    if (!this.#hasMoved(point[along] - this.#from[along])) return;
    const way = point[along] - this.#last;
    this.#last = point[along];
    const finer = isFine(point[across] - this.#from[across]);
    this.#model.refine(finer);
    const before = this.#valueAt(layout, this.#at);
    this.#at += way;
    if (finer) {
      const plain = this.#valueAt(layout, this.#at) - before;
      this.#at = this.#placeOf(layout, before + refined(plain, way, stepSize(program.identity, field)));
    }
    if (field.kind === 'time' && !finer) {
      this.#followPointer(layout, point);
      return;
    }
    this.#edit.move(snapped(program, field, this.#valueAt(layout, this.#at)));
    if (field.kind === 'time') this.#keepInView(layout);
  }

  up(geometry: Geometry, point: Point): void {
    this.move(geometry, point);
    cancelAnimationFrame(this.#frame);
    this.#edit.finish();
    this.#model.letGo();
  }

  cancel(): void {
    cancelAnimationFrame(this.#frame);
    this.#edit.cancel();
    this.#model.letGo();
  }

  /** Whether the pointer really moves it, not only trembles. @param way from where it was taken. */
  #hasMoved(way: number): boolean {
    if (this.#moved || Math.abs(way) < Math.max(1, this.#tremble)) return this.#moved;
    this.#last += Math.sign(way) * this.#tremble;
    this.#moved = true;
    return true;
  }

  /** The value at a place along the way of the handle, not rounded. */
  #valueAt(layout: Layout, at: number): number {
    const { field } = this.#edit;
    return field.kind === 'position' ? layout.position(field.servo, at) : layout.time(at);
  }

  #placeOf(layout: Layout, value: number): number {
    const { field } = this.#edit;
    return field.kind === 'position' ? layout.y(field.servo, value) : layout.x(value);
  }

  /** Moves a time with the pointer. It stays in the plot; beyond the edge the picture follows, frame by frame. */
  #followPointer(layout: Layout, point: Point): void {
    const { program, field, value } = this.#edit;
    const { left, right } = layout.box;
    const beside = Math.min(0, point.x - left) + Math.max(0, point.x - right);
    const { min, max } = limitsOf(program, field);
    if ((beside > 0 && value < max) || (beside < 0 && value > min)) {
      this.#model.pan((beside * FOLLOW) / layout.width, true);
      this.#frame = requestAnimationFrame(() => this.move(this.#drawn(), point));
    }
    const at = Math.min(right, Math.max(left, this.#at));
    this.#edit.move(snapped(program, field, layout.time(at)));
  }

  /** A handle that is moved finely takes the picture with it at its edges. */
  #keepInView(layout: Layout): void {
    const { left, right } = layout.box;
    const beside = this.#at - Math.min(right, Math.max(left, this.#at));
    if (beside === 0) return;
    this.#at -= beside;
    this.#model.pan(beside / layout.width, true);
  }
}
