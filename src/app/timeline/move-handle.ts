import { valueAt } from '../../program/index.js';
import { stepSize } from '../editing/edit.js';
import { type DragEdit, limitsOf, snapped } from './drag.js';
import type { Layout } from './layout.js';
import type { Point } from './under-pointer.js';
import type { TimelineModel } from './view-model.js';

/** Up to this distance from where it took the handle, the pointer moves the value as far as itself. In pixels. */
const PLAIN = 90;
/** Beyond, one step of the value takes at least this many pixels, so that a finger finds each. */
const STEP = 10;
/** And the handle goes at most this share of the pointer's way. */
const SLOW = 1 / 4;

/** Whether a value moves finely. @param away the distance from where it was taken, across the movement, in pixels. */
export function isFine(away: number): boolean {
  return Math.abs(away) > PLAIN;
}

/**
 * How far a value moves finely.
 * @param plain how far it would move with the pointer.
 * @param way the way of the pointer in pixels.
 * @param step of the value.
 */
export function refined(plain: number, way: number, step: number): number {
  return plain === 0 ? 0 : plain * Math.min(SLOW, (Math.abs(way) * step) / STEP / Math.abs(plain));
}

/** Outside of the plot the picture follows the handle, in each frame by this share of the distance. */
const FOLLOW = 0.02;

/** A handle is held and moves its value. Far from where it took the handle, the pointer moves it finely. */
export class MoveHandle {
  readonly #model: TimelineModel;
  readonly #edit: DragEdit;
  readonly #from: Point;
  readonly #layout: () => Layout;
  /** How far the pointer may tremble, in pixels. */
  readonly #tremble: number;
  /** The last reported place of the pointer, along the way of the handle. */
  #last: number;
  /** Where the handle would be without steps and limits, along its way, in pixels. */
  #at: number;
  #moved = false;
  #frame = 0;

  /** @param layout gives it as last drawn. */
  constructor(model: TimelineModel, edit: DragEdit, from: Point, layout: () => Layout, tremble: number) {
    this.#model = model;
    this.#edit = edit;
    this.#from = from;
    this.#layout = layout;
    this.#tremble = tremble;
    this.#last = edit.field.kind === 'time' ? from.x : from.y;
    this.#at = this.#placeOf(valueAt(edit.program, edit.field) ?? 0);
    model.take(edit, layout().scale);
  }

  move(point: Point): void {
    cancelAnimationFrame(this.#frame);
    const { program, field } = this.#edit;
    const isTime = field.kind === 'time';
    const [along, across] = isTime ? (['x', 'y'] as const) : (['y', 'x'] as const);
    if (!this.#hasMoved(point[along] - this.#from[along])) return;
    const way = point[along] - this.#last;
    this.#last = point[along];
    const finer = isFine(point[across] - this.#from[across]);
    this.#model.refine(finer);
    if (finer) {
      const before = this.#valueAt(this.#at);
      const plain = this.#valueAt(this.#at + way) - before;
      this.#at = this.#placeOf(before + refined(plain, way, stepSize(program.identity, field)));
    } else this.#at += way;
    const { box, width } = this.#layout();
    const inPlot = isTime ? Math.min(box.right, Math.max(box.left, this.#at)) : this.#at;
    const beside = this.#at - inPlot;
    this.#edit.move(snapped(program, field, this.#valueAt(finer ? this.#at : inPlot)));
    if (beside === 0) return;
    if (finer) {
      // It takes the picture with it.
      this.#at = inPlot;
      this.#model.pan(beside / width, true);
      return;
    }
    // It stays in the plot, and the picture follows, frame by frame.
    const { min, max } = limitsOf(program, field);
    if (this.#edit.value === (beside > 0 ? max : min)) return;
    this.#model.pan((beside * FOLLOW) / width, true);
    this.#frame = requestAnimationFrame(() => this.move(point));
  }

  /** Releases the handle. @param point null when it was not meant, which puts back what it changed. */
  end(point: Point | null): void {
    if (point) this.move(point);
    cancelAnimationFrame(this.#frame);
    this.#edit.end(point !== null);
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
  #valueAt(at: number): number {
    const { field } = this.#edit;
    return field.kind === 'position' ? this.#layout().position(field.servo, at) : this.#layout().time(at);
  }

  #placeOf(value: number): number {
    const { field } = this.#edit;
    return field.kind === 'position' ? this.#layout().y(field.servo, value) : this.#layout().x(value);
  }
}
