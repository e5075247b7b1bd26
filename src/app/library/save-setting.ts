import { type ReadonlySignal, signal } from '@preact/signals';
import type { Setting } from '../../program/index.js';
import { emptyModel, newId } from '../session/library.js';
import type { Session } from '../session/session.js';

/**
 * The dialog that saves the program on the screen.
 * - `name`: under which name and model?
 * - `elsewhere`: another tab has saved the open setting in the meantime; which version stays?
 */
export type SaveStep = { readonly step: 'name' } | { readonly step: 'elsewhere'; readonly theirs: Setting };

/** The pilot's choices for a new setting. */
export interface Named {
  readonly name: string;
  readonly note: string;
  /** The id of a model; null for none; or the name of a new one. */
  readonly model: string | null | { readonly name: string };
}

/** Saves the program on the screen in the library. */
export class SaveSetting {
  readonly #current = signal<SaveStep | null>(null, { name: 'saveSetting' });
  readonly current: ReadonlySignal<SaveStep | null> = this.#current;
  readonly #session: Session;

  constructor(session: Session) {
    this.#session = session;
  }

  /** Asks for the name of the new setting. */
  open(): void {
    if (this.#session.editor.working.peek()) this.#current.value = { step: 'name' };
  }

  /** Saves the open setting. Asks first when another tab has saved it, or when none is open. */
  async save(): Promise<void> {
    const { shown, unsaved, savable } = this.#session.opened;
    const setting = shown.peek()?.setting;
    if (!setting || !savable.peek()) return this.open();
    await this.#session.library.settings.look(setting.id);
    if (!unsaved.peek()?.elsewhere) await this.#session.opened.save();
    this.#askIfElsewhere();
  }

  /** Another tab may have saved the open setting just before, or during the save here. */
  #askIfElsewhere(): void {
    const { shown, unsaved } = this.#session.opened;
    const theirs = shown.peek()?.setting;
    if (theirs && unsaved.peek()?.elsewhere) this.#current.value = { step: 'elsewhere', theirs };
  }

  /** Replaces what another tab has saved. */
  async replace(): Promise<void> {
    this.#current.value = null;
    await this.#session.opened.save();
    this.#askIfElsewhere();
  }

  /** Takes what another tab has saved onto the screen, as a step that can be undone. */
  take(): void {
    this.#current.value = null;
    this.#session.opened.takeSaved();
  }

  /** @returns once the browser has saved it, or failed to. It is in the library at once. */
  async saveAs({ name, note, model }: Named): Promise<void> {
    const { library, opened, editor } = this.#session;
    const timerClass = editor.identity.peek()?.timerClass ?? null;
    if (!opened.savable.peek()) return;
    this.#current.value = null;
    const isNew = model !== null && typeof model === 'object';
    const id = isNew ? newId() : model;
    const keeping = isNew && id !== null ? library.keepModel(emptyModel(id, model.name, timerClass)) : null;
    await Promise.all([keeping, opened.saveAs({ model: id, name, note })]);
  }

  dismiss(): void {
    this.#current.value = null;
  }
}
