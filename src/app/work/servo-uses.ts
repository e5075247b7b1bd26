import { computed, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { DUTIES, LIMITS, type ServoUse } from '../../program/index.js';
import { MAX_POSITION } from '../../protocol/index.js';
import { loadSetting, saveSetting } from '../browser/settings.js';

/** The uses of servos belong to one model's timer. The kind of timer comes closest to that. */
export interface ServosAtHand {
  /** See `kindKey`. */
  readonly kind: string;
  readonly servos: number;
}

const step = v.pipe(v.number(), v.integer(), v.minValue(0), v.maxValue(MAX_POSITION));
const schema = v.array(
  v.object({
    duty: v.picklist(DUTIES),
    name: v.pipe(v.string(), v.maxLength(LIMITS.servoName)),
    low: step,
    high: step,
    reversed: v.boolean(),
  }),
);

type Said = readonly ServoUse[] | null;

/** The uses of one model's servos. */
export interface ServosOfModel {
  /** Empty when the pilot has said nothing. */
  readonly servos: readonly ServoUse[];
  say(servos: readonly ServoUse[]): void;
}

/**
 * What the servos of the model move, as the pilot says.
 * Kept with the model when it is known, else for each kind of timer.
 */
export class ServoUses {
  /** One entry for each servo; null when the pilot has said nothing. A drawing then has to guess. */
  readonly named: ReadonlySignal<Said>;
  readonly #atHand: ReadonlySignal<ServosAtHand | null>;
  readonly #ofModel: ReadonlySignal<ServosOfModel | null>;
  /** What was said since the page opened, by kind: all that there is where the browser keeps nothing. */
  readonly #said = signal<ReadonlyMap<string, Said>>(new Map());

  /** @param ofModel null while the model is not known. */
  constructor(
    atHand: ReadonlySignal<ServosAtHand | null>,
    ofModel: ReadonlySignal<ServosOfModel | null> = signal(null),
  ) {
    this.#atHand = atHand;
    this.#ofModel = ofModel;
    this.named = computed(() => {
      const { value } = this.#atHand;
      if (!value) return null;
      const own = this.#ofModel.value?.servos;
      if (own?.length === value.servos) return own;
      const said = this.#said.value.get(value.kind);
      const uses = said === undefined ? loadSetting(settingOf(value), v.nullable(schema)) : said;
      return uses?.length === value.servos ? uses : null;
    });
  }

  /** @param uses one for each servo; null forgets them. */
  say(uses: Said): void {
    const atHand = this.#atHand.peek();
    if (!atHand) return;
    const model = this.#ofModel.peek();
    model?.say(uses ?? []);
    // Uses that were said before the model was known are removed with it.
    if (model && uses) return;
    this.#said.value = new Map(this.#said.peek()).set(atHand.kind, uses);
    saveSetting(settingOf(atHand), uses);
  }
}

function settingOf({ kind }: ServosAtHand): string {
  return `servos/${kind}`;
}
