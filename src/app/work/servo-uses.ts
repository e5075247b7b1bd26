import { computed, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { DUTIES, LIMITS, type ServoUse } from '../../program/index.js';
import { MAX_POSITION } from '../../protocol/index.js';
import { loadSetting, saveSetting } from '../browser/settings.js';
import type { Editor } from '../editing/editor.js';
import type { Library } from '../records/library.js';
import { kindKey } from '../timer/record-keys.js';
import type { OnScreen } from './on-screen.js';
import type { Origin } from './origin.js';

interface ServoUsesParts {
  readonly editor: Pick<Editor, 'identity'>;
  readonly onScreen: Pick<OnScreen, 'simulated'>;
  readonly origin: Pick<Origin, 'named'>;
  readonly library: Pick<Library, 'changeModel'>;
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

/**
 * What the servos of the model move, as the pilot says.
 * Kept with the model when it is known. Else for each kind of timer: that comes closest to a model.
 */
export class ServoUses {
  /** One entry for each servo; null when the pilot has said nothing. A drawing then has to guess. */
  readonly named: ReadonlySignal<Said>;
  readonly #parts: ServoUsesParts;
  /** See `kindKey`. Null while nothing is on the screen. */
  readonly #kind: ReadonlySignal<string | null>;
  /** What was said since the page opened, by kind: all that there is where the browser keeps nothing. */
  readonly #said = signal<ReadonlyMap<string, Said>>(new Map());

  constructor(parts: ServoUsesParts) {
    this.#parts = parts;
    const { editor, onScreen, origin } = parts;
    this.#kind = computed(() => editor.identity.value && kindKey(editor.identity.value, onScreen.simulated.value));
    this.named = computed(() => {
      const kind = this.#kind.value;
      const count = editor.identity.value?.servos;
      if (kind === null) return null;
      const own = origin.named.value?.servos;
      if (own && own.length === count) return own;
      const said = this.#said.value.get(kind);
      const uses = said === undefined ? loadSetting(settingOf(kind), v.nullable(schema)) : said;
      return uses && uses.length === count ? uses : null;
    });
  }

  /** @param uses one for each servo; null forgets them. */
  say(uses: Said): void {
    const { origin, library } = this.#parts;
    const kind = this.#kind.peek();
    if (kind === null) return;
    const model = origin.named.peek();
    if (model) void library.changeModel(model.id, { servos: uses ?? [] });
    // Uses that were said before the model was known are removed with it.
    if (model && uses) return;
    this.#said.value = new Map(this.#said.peek()).set(kind, uses);
    saveSetting(settingOf(kind), uses);
  }
}

function settingOf(kind: string): string {
  return `servos/${kind}`;
}
