import type { TimelineModel } from '../view-model.js';
import type { Gesture, Point, Target } from './gesture.js';
import { placeUnder } from './under-pointer.js';

/** Two fingers closer than this share of the plot do not move the view. */
const CLOSEST = 0.02;

/** Two fingers are down: the places under them stay under them. */
export class Pinch implements Gesture {
  readonly holdsPage = true;
  readonly #model: TimelineModel;
  readonly #fingers: ReadonlyMap<number, Point>;
  /** The place of the scale under each finger at the beginning. */
  readonly #places: ReadonlyMap<number, number>;

  /** @param fingers where each finger is; updated while they move. */
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
