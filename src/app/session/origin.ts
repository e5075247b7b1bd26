import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import type { Model } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';
import { type Crossing, crossingOf } from './crossing.js';
import type { Library } from './library.js';
import type { OpenSetting } from './open-setting.js';
import type { Recognition } from './recognition.js';

interface OriginParts {
  readonly editor: Editor;
  readonly library: Library;
  readonly recognition: Recognition;
  readonly opened: OpenSetting;
}

interface Taken {
  readonly model: string;
  /** See `Recognition.timer`; null: it came from elsewhere than a timer. */
  readonly timer: number | null;
}

/**
 * For which model the values on the screen are: that of the setting that is open; else the one whose timer was there
 * when the first change was typed, or whose backup was loaded. They stay where another timer takes its place, and must
 * not go into that one unasked.
 */
export class Origin {
  /** Its id; null where nothing is changed, or it is not known. */
  readonly key: ReadonlySignal<string | null>;
  /** Null also where the library has none of that id. */
  readonly model: ReadonlySignal<Model | null>;
  /** Null where what is on the screen belongs to the timer at hand, as far as that is known. */
  readonly crossing: ReadonlySignal<Crossing | null>;
  readonly #editor: Editor;
  readonly #taken = signal<Taken | null>(null, { name: 'origin' });

  constructor({ editor, library, recognition, opened }: OriginParts) {
    this.key = computed(() => {
      // A backup says itself whose it is, through every undo; and so does a setting.
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
      // What is said of the timer on which they were made holds for them, too.
      else if (model && (!taken || taken.timer === timer)) this.#taken.value = { model, timer };
    });
  }

  /** Changes come to the screen that were made for this model. To be called after they have. */
  take(model: string | undefined): void {
    if (model !== undefined && this.#editor.dirty.peek()) this.#taken.value = { model, timer: null };
  }
}
