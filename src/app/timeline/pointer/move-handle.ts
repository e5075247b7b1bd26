import { type ProgramField, valueAt } from '../../../program/index.js';
import { stepSize } from '../../editing/edit.js';
import { DragEdit, limitsOf, type OnEdit, snapped } from '../drag.js';
import type { Layout } from '../layout.js';
import type { TimelineModel } from '../view-model.js';
import { finenessAt, refined } from './fineness.js';
import type { Gesture, Point, Report, Target } from './gesture.js';

/** Outside of the plot the picture follows the handle, in each frame by this share of the distance. */
const FOLLOW = 0.02;

/** How far a tapping finger may tremble, in pixels. */
const TREMBLE = 5;

/** A handle is held and moves its value. The further the pointer is from where it took the handle, the finer. */
export class MoveHandle implements Gesture {
  readonly holdsPage = true;
  readonly #model: TimelineModel;
  readonly #edit: DragEdit;
  readonly #from: Point;
  /** The last reported place of the pointer, along the way of the handle. */
  #last: number;
  /** Where the handle would be without steps and limits, along its way, in pixels. */
  #at: number;
  #moved = false;

  constructor(
    model: TimelineModel,
    { geometry: { layout }, now }: Target,
    { field, from, onEdit }: { readonly field: ProgramField; readonly from: Point; readonly onEdit: OnEdit },
  ) {
    const program = now();
    const value = valueAt(program, field) ?? 0;
    this.#model = model;
    this.#edit = new DragEdit(now, field, onEdit);
    this.#from = from;
    this.#last = field.kind === 'time' ? from.x : from.y;
    this.#at = this.#placeOf(layout, value);
    model.take(this.#edit, layout.scale);
  }

  move({ geometry: { layout } }: Target, { point, free, coarse }: Report): boolean {
    const { program, field } = this.#edit;
    const [along, across] = field.kind === 'time' ? (['x', 'y'] as const) : (['y', 'x'] as const);
    if (!this.#hasMoved(point[along] - this.#from[along], coarse ? TREMBLE : 0)) return false;
    const way = point[along] - this.#last;
    this.#last = point[along];
    const fineness = finenessAt(point[across] - this.#from[across]);
    this.#model.refine(fineness > 0);
    const before = this.#valueAt(layout, this.#at);
    this.#at += way;
    if (fineness > 0) {
      const plain = this.#valueAt(layout, this.#at) - before;
      this.#at = this.#placeOf(layout, before + refined(plain, way, stepSize(program.identity, field), fineness));
    }
    if (field.kind === 'time' && fineness === 0) return this.#followPointer(layout, point.x, free);
    this.#edit.move(snapped(program, field, this.#valueAt(layout, this.#at), free));
    if (field.kind === 'time') this.#keepInView(layout);
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

  /**
   * Whether the pointer really moves it. The trembling of a finger does not count. @param way from where it was taken.
   */
  #hasMoved(way: number, trembling: number): boolean {
    if (this.#moved || Math.abs(way) < Math.max(1, trembling)) return this.#moved;
    this.#last += Math.sign(way) * trembling;
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

  /**
   * Moves a time with the pointer. It stays in the plot; beyond the edge the picture follows.
   * @returns whether the picture follows: the pointer stands still there and sends no reports.
   */
  #followPointer(layout: Layout, x: number, free: boolean): boolean {
    const { program, field, value } = this.#edit;
    const { left, right } = layout.box;
    const beside = Math.min(0, x - left) + Math.max(0, x - right);
    const { min, max } = limitsOf(program, field, free);
    const follows = (beside > 0 && value < max) || (beside < 0 && value > min);
    if (follows) this.#model.pan((beside * FOLLOW) / layout.width, true);
    const at = Math.min(right, Math.max(left, this.#at));
    this.#edit.move(snapped(program, field, layout.time(at), free));
    return follows;
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
