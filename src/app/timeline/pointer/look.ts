import type { Geometry } from '../geometry.js';
import type { TimelineModel } from '../view-model.js';
import type { Gesture } from './pointer-control.js';
import { type Point, servoUnder, timeUnder } from './under-pointer.js';

/** A smaller movement counts as standing still, in pixels. */
const STILL = 4;

/**
 * The pointer is down beside the handles: it asks for the time, or moves the view.
 * A click selects the servo of the lane.
 */
export class Look implements Gesture {
  readonly #model: TimelineModel;
  readonly #from: Point;
  /** Whether the picture is larger than the view. */
  readonly #pans: boolean;
  #last: Point;
  #moved = false;

  constructor(model: TimelineModel, geometry: Geometry, from: Point) {
    this.#model = model;
    this.#from = this.#last = from;
    this.#pans = model.zoomed;
    this.move(geometry, from);
  }

  move(geometry: Geometry, point: Point): void {
    this.#moved ||= Math.abs(point.x - this.#from.x) > STILL;
    if (this.#pans && this.#moved) {
      this.#model.pan((this.#last.x - point.x) / geometry.layout.width);
      this.#last = point;
    } else this.#model.ask(timeUnder(geometry, point.x));
  }

  up(geometry: Geometry, point: Point): void {
    this.move(geometry, point);
    if (this.#moved) return;
    const servo = servoUnder(geometry, this.#from);
    if (servo !== null) this.#model.bringToFront(servo);
  }

  cancel(): void {}
}
