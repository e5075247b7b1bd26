import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import type { Model, Setting, TimerProgram } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';
import { type Crossing, crossingOf } from '../records/crossing.js';
import type { Library } from '../records/library.js';
import type { Recognition } from '../records/recognition.js';

interface OriginParts {
  readonly editor: Pick<Editor, 'working' | 'dirty' | 'madeAt' | 'of' | 'backupOf' | 'baseline'>;
  readonly library: Library;
  readonly recognition: Pick<Recognition, 'found' | 'model' | 'timer'>;
  readonly connection: ReadonlySignal<unknown>;
}

interface Taken {
  readonly model: string;
  /** See `Recognition.timer`; null when it did not come from a timer. */
  readonly timer: number | null;
}

/**
 * Whose the values are. Every name of a model on the screen, on paper, in a link and in a file comes from here, and so
 * does where “Save” saves. The values on the screen belong to the open setting; else to the model whose backup was
 * loaded; else to the one whose timer was connected at the first change, or from whose timer they were read. They stay
 * when another timer comes, and must not go into that one without a question.
 */
export class Origin {
  /** The id of the model of what would be lost with the screen; null when nothing would, or it is not known. */
  readonly key: ReadonlySignal<string | null>;
  /** The model of the values on the screen; null when they have none, or it is not known. */
  readonly model: ReadonlySignal<Model | null>;
  /**
   * The setting of the values on the screen, changed or not; null when they are of none. A deleted one comes back when
   * its deletion is undone.
   */
  readonly setting: ReadonlySignal<Setting | null>;
  /**
   * The model of the connected timer; without one, of the timer whose reading is still on the screen. Null when that is
   * not known.
   */
  readonly timer: ReadonlySignal<Model | null>;
  /** The model that names memories and servos: of the timer, or else of a program that is of no timer. */
  readonly named: ReadonlySignal<Model | null>;
  /** Whether the values are those of the timer, or were typed over them. */
  readonly isOfTimer: ReadonlySignal<boolean>;
  /**
   * The program on the screen as its model has it: while it lies over what the timer of another model holds, it is not
   * of the memory of that timer.
   */
  readonly program: ReadonlySignal<TimerProgram | null>;
  /** Null when the values belong to the connected timer, as far as that is known. */
  readonly crossing: ReadonlySignal<Crossing | null>;
  readonly #parts: OriginParts;
  readonly #taken = signal<Taken | null>(null, { name: 'origin' });
  /** The id of the model from whose timer the baseline was read. */
  readonly #readOf = signal<string | null>(null, { name: 'readOf' });

  constructor(parts: OriginParts) {
    this.#parts = parts;
    const { editor, library, recognition, connection } = parts;
    const modelOf = (key: string | null | undefined): Model | null => library.models.get(key ?? null)?.model ?? null;
    this.key = computed(() => {
      // A backup, like a setting, keeps its own model through every undo.
      const isChanged = editor.dirty.value || editor.madeAt.value !== null;
      return (isChanged ? editor.backupOf.value : undefined) ?? this.#taken.value?.model ?? null;
    });
    this.timer = computed(() => {
      if (connection.value) return recognition.model.value;
      return editor.baseline.value ? modelOf(this.#readOf.value) : null;
    });
    this.setting = computed(() => library.settings.get(editor.of.value?.id ?? null)?.setting ?? null);
    this.isOfTimer = computed(
      () => editor.baseline.value !== null && !this.setting.value && editor.backupOf.value === undefined,
    );
    this.model = computed(() => {
      if (this.setting.value) return modelOf(this.setting.value.model);
      if (editor.backupOf.value !== undefined) return modelOf(editor.backupOf.value);
      return editor.dirty.value ? modelOf(this.#taken.value?.model) : this.timer.value;
    });
    this.named = computed(() => (connection.value || editor.baseline.value ? this.timer : this.model).value);
    this.program = computed(() => {
      const working = editor.working.value;
      const isHome = editor.baseline.value !== null && this.model.value?.id === this.timer.value?.id;
      if (!working || isHome) return working;
      const memory = this.setting.value?.program.memory ?? null;
      return { ...working, memory: memory !== null && memory < working.identity.memories ? memory : null };
    });
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
    effect(() => {
      if (connection.value && editor.baseline.value) this.#readOf.value = recognition.model.value?.id ?? null;
    });
  }

  /** Whether values of this model, by its id, would go into the timer of another. */
  crossingFrom(key: string | null): Crossing | null {
    const { library, recognition } = this.#parts;
    return crossingOf(library.models.get(key)?.model ?? null, recognition.found.value);
  }

  /** Work that was kept has come to the screen, with the model that it was for. Call it afterwards. */
  take(model: string | undefined): void {
    const { editor, connection, recognition } = this.#parts;
    // A backup is of its own model, which need not be that of the timer that was connected.
    const isRead = editor.backupOf.peek() === undefined;
    if (!connection.peek()) this.#readOf.value = (isRead && model) || null;
    // Of work that nobody has given to a model, only the timer that is there can say it.
    const found = recognition.model.peek()?.id;
    const said =
      model === undefined ? found && { model: found, timer: recognition.timer.peek() } : { model, timer: null };
    this.#taken.value = (editor.dirty.peek() && said) || null;
  }
}
