import { valueAt } from '../../program/index.js';
import { type DragEdit, limitsOf, snapped } from './drag.js';
import type { Layout } from './layout.js';
import type { Point } from './under-pointer.js';
import type { TimelineModel } from './view-model.js';

/** Outside of the plot the picture follows the handle, in each frame by this share of the distance. */
const FOLLOW = 0.02;

/** A handle is held and moves its value as far as the pointer moves. */
export class MoveHandle {
  readonly #model: TimelineModel;
  readonly #edit: DragEdit;
  readonly #from: Point;
  readonly #layout: () => Layout;
  /** How far the pointer may tremble, in pixels. */
  readonly #tremble: number;
  readonly #original: number;
  /** Where the handle was taken, along its way, in pixels. */
  readonly #start: number;
  #frame = 0;

  /** @param layout gives it as last drawn. */
  constructor(model: TimelineModel, edit: DragEdit, from: Point, layout: () => Layout, tremble: number) {
    const { field, program } = edit;
    this.#model = model;
    this.#edit = edit;
    this.#from = from;
    this.#layout = layout;
    this.#tremble = tremble;
    this.#original = valueAt(program, field) ?? 0;
    this.#start = field.kind === 'position' ? layout().y(field.servo, this.#original) : layout().x(this.#original);
    model.take(edit, layout().scale);
  }

  move(point: Point): void {
    cancelAnimationFrame(this.#frame);
    const { program, field } = this.#edit;
    const { box, width, position, time } = this.#layout();
    const moved = field.kind === 'position' ? point.y - this.#from.y : point.x - this.#from.x;
    const way = Math.sign(moved) * Math.max(0, Math.abs(moved) - this.#tremble);
    const at = this.#start + way;
    const to = (value: number): void => this.#edit.move(snapped(program, field, value));
    if (way === 0) {
      this.#edit.move(this.#original);
      return;
    }
    if (field.kind === 'position') {
      to(position(field.servo, at));
      return;
    }
    const inPlot = Math.min(box.right, Math.max(box.left, at));
    to(time(inPlot));
    // It stays in the plot, and the picture follows, frame by frame.
    const { min, max } = limitsOf(program, field);
    if (at === inPlot || this.#edit.value === (at > inPlot ? max : min)) return;
    this.#model.pan(((at - inPlot) * FOLLOW) / width, true);
    this.#frame = requestAnimationFrame(() => this.move(point));
  }

  /** Releases the handle. @param point null when it was not meant, which puts back what it changed. */
  end(point: Point | null): void {
    if (point) this.move(point);
    cancelAnimationFrame(this.#frame);
    this.#edit.end(point !== null);
    this.#model.letGo();
  }
}
