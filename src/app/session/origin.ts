import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import type { Model } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';
import { type Crossing, crossingOf } from './crossing.js';
import type { Session } from './session.js';

type OriginParts = Pick<Session, 'editor' | 'library' | 'recognition' | 'opened'>;

interface Taken {
  readonly model: string;
  /** See `Recognition.timer`; null when it did not come from a timer. */
  readonly timer: number | null;
}

/**
 * The model for which the values on the screen are: the model of the open setting; else the one whose timer was
 * connected at the first change, or whose backup was loaded. The values stay when another timer comes, and must not go
 * into that one without a question.
 */
export class Origin {
  /** Its id; null when nothing is changed, or the model is not known. */
  readonly key: ReadonlySignal<string | null>;
  /** Null also when the library has no model of that id. */
  readonly model: ReadonlySignal<Model | null>;
  /** Null when the values belong to the connected timer, as far as that is known. */
  readonly crossing: ReadonlySignal<Crossing | null>;
  readonly #editor: Editor;
  readonly #taken = signal<Taken | null>(null, { name: 'origin' });

  constructor({ editor, library, recognition, opened }: OriginParts) {
    this.key = computed(() => {
      // A backup, like a setting, keeps its own model through every undo.
      const isChanged = editor.dirty.value || editor.madeAt.value !== null;
      return (isChanged ? editor.backupOf.value : undefined) ?? this.#taken.value?.model ?? null;
    });
    this.model = computed(() => {
      const ofKey = library.models.get(this.key.value)?.model;
      const ofSetting = opened.shown.value?.model;
      return (editor.backupOf.value === undefined ? ofSetting : (ofKey ?? ofSetting)) ?? ofKey ?? null;
    });
    this.#editor = editor;
    this.crossing = computed(() => crossingOf(this.model.value, recognition.found.value));
    effect(() => {
      const isDirty = editor.dirty.value;
      const model = recognition.model.value?.id;
      const timer = recognition.timer.value;
      const taken = this.#taken.peek();
      if (!isDirty) this.#taken.value = null;
      // What the pilot says about the timer on which the changes were made counts for them, too.
      else if (model && (!taken || taken.timer === timer)) this.#taken.value = { model, timer };
    });
  }

  /** Changes for this model have come to the screen. Call it afterwards. */
  take(model: string | undefined): void {
    if (model !== undefined && this.#editor.dirty.peek()) this.#taken.value = { model, timer: null };
  }
}
