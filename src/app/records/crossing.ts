import type { Model } from '../../program/index.js';
import type { FoundModel } from './recognition.js';

/** Values of one model that are about to go into the timer of another. */
export interface Crossing {
  readonly from: Model;
  /** The models that the timer looks like: one, or several equal ones. */
  readonly to: readonly Model[];
}

/**
 * Whether values would go from one model to another.
 * @param from the model that the values belong to; null when it is not known.
 * @param found the model that the timer belongs to.
 * @returns null when they would not, or nothing shows that they would.
 */
export function crossingOf(from: Model | null, found: FoundModel | null): Crossing | null {
  if (!from || !found || found.kind === 'unknown') return null;
  const to = 'model' in found ? [found.model] : found.candidates.map(({ model }) => model);
  return to.some(({ id }) => id === from.id) ? null : { from, to };
}

/** Whether both look the same to the pilot, who reads names. */
export function sameCrossing(a: Crossing | null, b: Crossing | null): boolean {
  return textOf(a) === textOf(b);
}

/** Whether both are the same model with the same name. */
export function sameModel(a: Model | null, b: Model | null): boolean {
  return a?.id === b?.id && a?.name === b?.name;
}

function textOf(crossing: Crossing | null): string {
  return JSON.stringify(crossing && [crossing.from, ...crossing.to].map(({ id, name }) => [id, name]));
}
