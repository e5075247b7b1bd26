import { type ProgramField, valueAt } from '../../../program/index.js';
import { DragEdit, limitsOf, type OnEdit, snapped } from '../drag.js';
import type { Layout } from '../layout.js';
import type { TimelineModel } from '../view-model.js';
import type { Gesture, Point, Report, Target } from './gesture.js';

/** Beside the plot the picture follows a handle, by this share of the way it is beside it, in each frame. */
const FOLLOW = 0.02;

/** A handle is in hand, and its value with it. */
export class MoveHandle implements Gesture {
  readonly holdsPage = true;
  readonly #model: TimelineModel;
  readonly #edit: DragEdit;
  readonly #from: Point;
  /** From the pointer to where the value lies: what is moved keeps its distance. */
  readonly #offset: Point;

  constructor(
    model: TimelineModel,
    { geometry: { layout }, now }: Target,
    { field, from, onEdit }: { readonly field: ProgramField; readonly from: Point; readonly onEdit: OnEdit },
  ) {
    const program = now();
    const value = valueAt(program, field) ?? 0;
    this.#model = model;
    this.#edit = new DragEdit(program, field, onEdit);
    this.#from = from;
    this.#offset = { x: layout.x(value) - from.x, y: layout.y(value) - from.y };
    model.take(this.#edit, layout.scale);
  }

  move({ geometry: { layout } }: Target, { point, free }: Report): boolean {
    if (this.#edit.field.kind === 'time') return this.#moveTime(layout, point, free);
    const { program, field } = this.#edit;
    const hasMoved = Math.abs(point.y - this.#from.y) >= 1;
    if (hasMoved) this.#edit.move(snapped(program, field, layout.position(point.y + this.#offset.y)));
    return false;
  }

  up(target: Target, report: Report): void {
    this.move(target, report);
    this.#edit.finish();
    this.#model.letGo();
  }

  cancel(): void {
    this.#edit.cancel();
    this.#model.letGo();
  }

  #moveTime(layout: Layout, point: Point, free: boolean): boolean {
    const edit = this.#edit;
    if (Math.abs(point.x - this.#from.x) < 1) return false;
    const { left, right } = layout.box;
    const beside = Math.min(0, point.x - left) + Math.max(0, point.x - right);
    const { min, max } = limitsOf(edit.program, edit.field, free);
    const follows = (beside > 0 && edit.value < max) || (beside < 0 && edit.value > min);
    if (follows) this.#model.pan((beside * FOLLOW) / layout.width, true);
    const x = Math.min(right, Math.max(left, point.x + this.#offset.x));
    edit.move(snapped(edit.program, edit.field, layout.time(x), free));
    // Nothing reports while the pointer stands still beside the plot.
    return follows;
  }
}
