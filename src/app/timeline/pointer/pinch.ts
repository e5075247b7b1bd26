import type { TimelineModel } from '../view-model.js';
import type { Gesture, Point, Target } from './gesture.js';
import { placeUnder } from './under-pointer.js';

/** Fingers closer than this share of the plot are not told apart. */
const CLOSEST = 0.02;

/** Two fingers are down: what was under each stays there. */
export class Pinch implements Gesture {
  readonly holdsPage = true;
  readonly #model: TimelineModel;
  readonly #fingers: ReadonlyMap<number, Point>;
  /** What each finger came down on, in places of the scale. */
  readonly #places: ReadonlyMap<number, number>;

  /** @param fingers where each finger is, as it is and as it changes. */
  constructor(model: TimelineModel, { geometry: { layout } }: Target, fingers: ReadonlyMap<number, Point>) {
    this.#model = model;
    this.#fingers = fingers;
    this.#places = new Map([...fingers].map(([id, { x }]) => [id, placeUnder(layout, x)]));
    model.ask(null);
  }

  move({ geometry: { layout } }: Target): boolean {
    const [a, b] = [...this.#fingers].map(([id, { x }]) => ({
      place: this.#places.get(id) ?? 0,
      share: (x - layout.box.left) / layout.width,
    }));
    if (a && b && Math.abs(a.share - b.share) >= CLOSEST) this.#model.hold(a, b);
    return false;
  }

  up(): void {}

  cancel(): void {}
}
