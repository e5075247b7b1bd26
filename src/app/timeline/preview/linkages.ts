import { type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { loadSetting, saveSetting } from '../../browser/settings.js';
import { type Linkages, usualLinkages } from './surfaces.js';

const linkage = v.object({ servo: v.nullable(v.pipe(v.number(), v.integer(), v.minValue(0))), reversed: v.boolean() });
const schema = v.object({ rudder: linkage, tailplane: linkage, wing: linkage });

/** Which servo moves what on the sketch of a model, for one kind of timer. */
export class KeptLinkages {
  readonly #name: string;
  readonly #value;

  /** @param kind under which they are kept. */
  constructor(kind: string, servos: number) {
    this.#name = `linkages/${kind}`;
    const kept = loadSetting(this.#name, schema);
    const fits = kept && Object.values(kept).every(({ servo }) => servo === null || servo < servos);
    this.#value = signal<Linkages>(fits ? kept : usualLinkages(servos));
  }

  get value(): ReadonlySignal<Linkages> {
    return this.#value;
  }

  readonly set = (linkages: Linkages): void => {
    this.#value.value = linkages;
    saveSetting(this.#name, linkages);
  };
}
