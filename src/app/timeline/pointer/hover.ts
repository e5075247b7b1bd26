import type { TimelineModel } from '../view-model.js';
import type { Gesture, Report, Target } from './gesture.js';
import { fieldUnder, timeUnder } from './under-pointer.js';

/** The pointer passes over: asks for the time, and shows by its shape what it could take. */
export class Hover implements Gesture {
  readonly holdsPage = false;
  readonly #model: TimelineModel;

  constructor(model: TimelineModel) {
    this.#model = model;
  }

  move(target: Target, { point, coarse }: Report): boolean {
    const field = fieldUnder(target, this.#model.front.value, point, coarse);
    target.svg.setAttribute('data-over', field?.kind ?? '');
    this.#model.pointAt(field);
    this.#model.ask(timeUnder(target.geometry, point.x));
    return false;
  }

  up(): void {}

  cancel(): void {}
}
