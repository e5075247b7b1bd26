import { type ReadonlySignal, signal } from '@preact/signals';
import type { Setting } from '../../program/index.js';
import { emptyModel, newId } from '../records/library.js';
import type { Session } from '../work/session.js';

/** The pilot's choices for a new setting. */
export interface Named {
  readonly name: string;
  readonly note: string;
  /** The id of a model; null for none; or the name of a new one. */
  readonly model: string | null | { readonly name: string };
  /** The setting of that name, which it replaces; its values stay as an earlier version. Default: none. */
  readonly over?: Setting | null;
}

type SaveParts = Pick<Session, 'editor' | 'library' | 'opened' | 'origin' | 'recognition'>;

/** Saves the program on the screen in the library. */
export class SaveSetting {
  readonly #asking = signal(false, { name: 'saveSetting' });
  /** Whether the dialog asks for the name and model of a new setting. */
  readonly asking: ReadonlySignal<boolean> = this.#asking;
  readonly #parts: SaveParts;

  constructor(parts: SaveParts) {
    this.#parts = parts;
  }

  /** Asks for the name of the new setting. */
  open(): void {
    if (this.#parts.editor.working.peek()) this.#asking.value = true;
  }

  /**
   * Saves the open setting. Asks first when none is open, or when the timer of another model has come under its
   * changes: all that was not typed is of that one.
   */
  async save(): Promise<void> {
    const { opened, origin, editor } = this.#parts;
    const isMixed = editor.isMoved.peek() && origin.crossing.peek() !== null;
    if (origin.setting.peek() && opened.savable.peek() && !isMixed) await opened.save();
    else this.open();
  }

  /** @returns once the browser has saved it, or failed to. It is in the library at once. */
  async saveAs({ name, note, model, over = null }: Named): Promise<void> {
    const { library, opened, editor, origin } = this.#parts;
    const isOfTimer = origin.isOfTimer.peek();
    const timerClass = editor.identity.peek()?.timerClass ?? null;
    if (!opened.savable.peek()) return;
    this.#asking.value = false;
    const isNew = model !== null && typeof model === 'object';
    const id = isNew ? newId() : model;
    const keeping = isNew && id !== null ? library.keepModel(emptyModel(id, model.name, timerClass)) : null;
    const saving = opened.saveAs({ model: id, name, note, over });
    if (isOfTimer) this.#say(id);
    await Promise.all([keeping, saving]);
  }

  /** Whoever saves what a timer holds under a model has said whose timer it is, unless the page knows another one. */
  #say(id: string | null): void {
    const { recognition, origin } = this.#parts;
    const model = recognition.choices.peek().find((each) => each.id === id);
    const known = origin.timer.peek();
    if (model && (!known || known.id === id)) recognition.say(model);
  }

  dismiss(): void {
    this.#asking.value = false;
  }
}
