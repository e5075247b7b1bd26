import { computed, type ReadonlySignal } from '@preact/signals';
import {
  type Model,
  requireProgram,
  type Setting,
  type SettingSource,
  sameLayout,
  type TimerProgram,
} from '../../program/index.js';
import { changesSince } from '../editing/content.js';
import { replaceAll } from '../editing/edit.js';
import { isOfOneShape } from '../editing/shape.js';
import type { Drafts } from './drafts.js';
import { newId } from './library.js';
import type { Session } from './session.js';

/** The open setting, and the model that it belongs to. */
export interface Opened {
  readonly model: Model | null;
  readonly setting: Setting | null;
}

/**
 * Why a setting cannot be shown now.
 * - `busy`: a job has the wire, or the page looks for a timer.
 * - `following`: the servos follow edits.
 * - `other-class`, `other-layout`: the connected timer cannot take it.
 */
export type ShowObstacle = 'busy' | 'following' | 'other-class' | 'other-layout';

/** How the program on the screen differs from the setting that it belongs to. */
export interface Unsaved {
  /** How many values differ from the library. */
  readonly changes: number;
  /** How many fields have a text that is no value. */
  readonly unreadable: number;
}

/** The name of a new setting, and where it goes. */
export interface NewSetting extends Pick<Setting, 'model' | 'name'>, Partial<Pick<Setting, 'note' | 'tags' | 'from'>> {}

/** The setting of the library that the program on the screen belongs to: opening it, and saving it. */
export class OpenSetting {
  /** Null when the program belongs to none. A deleted setting comes back when its deletion is undone. */
  readonly shown: ReadonlySignal<Opened | null>;
  /** Null when no setting is open. */
  readonly unsaved: ReadonlySignal<Unsaved | null>;
  /** Whether the program on the screen can be saved: each field has a value that a timer can hold. */
  readonly savable: ReadonlySignal<boolean>;
  readonly #session: Session;
  readonly #drafts: Drafts;
  #following: ReadonlySignal<boolean> | null = null;

  constructor(session: Session, drafts: Drafts) {
    this.#session = session;
    this.#drafts = drafts;
    const { editor, library } = session;
    const record = computed(() => library.settings.get(editor.of.value?.id ?? null));
    this.shown = computed(() => {
      const setting = record.value?.setting;
      return setting ? { setting, model: library.models.get(setting.model)?.model ?? null } : null;
    });
    this.unsaved = computed(() => {
      const of = editor.of.value;
      const working = editor.working.value;
      const held = record.value?.setting.program;
      if (!of || !working || !held) return null;
      const changes = sameLayout(held.identity, working.identity) ? changesSince(held, working).length : Infinity;
      return { changes, unreadable: editor.unreadable.value.size };
    });
    this.savable = computed(() => {
      const working = editor.working.value;
      return working !== null && editor.unreadable.value.size === 0 && isStorable(working);
    });
  }

  /** Shows no setting while this is true: the servos would move with it. */
  notWhile(following: ReadonlySignal<boolean>): void {
    this.#following = following;
  }

  /** Why a program cannot come to the screen now; null when it can. */
  obstacle(program: TimerProgram): ShowObstacle | null {
    const { connection, engaged, editor } = this.#session;
    if (engaged.value) return 'busy';
    if (!connection.value) return null;
    if (this.#following?.value) return 'following';
    const held = editor.baseline.value;
    if (!held) return 'busy';
    if (isOfOneShape(program.identity, held.identity)) return null;
    return program.identity.timerClass === held.identity.timerClass ? 'other-layout' : 'other-class';
  }

  /**
   * Opens a setting. Without a timer: to edit it, with its stored unsaved changes if there are any. With a connected
   * timer: over what the timer holds, as one step.
   * @returns whether it is shown.
   */
  async show(setting: Setting): Promise<boolean> {
    if (this.obstacle(setting.program)) return false;
    const { editor, connection, onScreen } = this.#session;
    if (connection.value) return this.#layOver(setting);
    if (editor.of.value?.id === setting.id && editor.madeAt.value !== null) return true;
    const kept = await this.#drafts.ofSetting(setting.id);
    // A timer may have come in the meantime.
    if (this.obstacle(setting.program) || connection.value) return false;
    // It belongs to no memory, so nothing that is known about a memory applies to it.
    if (kept) onScreen.showKept(kept);
    else onScreen.make({ ...setting.program, memory: null }, { of: openedFrom(setting) });
    return true;
  }

  /**
   * Saves the program on the screen as the open setting.
   * @returns whether the browser has stored it. It is in the library in any case.
   */
  async save(): Promise<boolean> {
    const opened = this.shown.peek()?.setting;
    const program = this.#program();
    if (!opened || !program) return false;
    const memory = program.memory ?? opened.program.memory;
    const setting: Setting = {
      ...opened,
      program: { ...program, memory: memory !== null && memory < program.identity.memories ? memory : null },
      at: Date.now(),
      from: this.source(),
    };
    return await this.#keep(setting);
  }

  /**
   * Saves the program on the screen as a new setting, which is then open.
   * @returns whether the browser has stored it. It is in the library in any case.
   */
  async saveAs({ model, name, note = '', tags = [], from = this.source() }: NewSetting): Promise<boolean> {
    const program = this.#program();
    if (!program) return false;
    const setting = { id: newId(), model, name, note, tags, at: Date.now(), program, from, archived: false };
    return await this.#keep(setting);
  }

  /** Brings the values of the open setting back to the screen, as one step. */
  loadAgain(): void {
    const setting = this.shown.peek()?.setting;
    const working = this.#session.editor.working.peek();
    if (setting && working && sameLayout(setting.program.identity, working.identity)) this.#layOver(setting);
  }

  /** Where the values on the screen come from. */
  source(): SettingSource {
    const { editor, onScreen } = this.#session;
    if (editor.baseline.peek() === null || editor.dirty.peek()) return 'typed';
    return onScreen.simulated.peek() ? 'simulated' : 'timer';
  }

  #layOver(setting: Setting): boolean {
    const name = { code: 'open', params: { name: setting.name } } as const;
    const of = openedFrom(setting);
    return this.#session.editor.apply({ ...replaceAll(name, setting.program), of }) === null;
  }

  #program(): TimerProgram | null {
    return this.savable.peek() ? this.#session.editor.working.peek() : null;
  }

  async #keep(setting: Setting): Promise<boolean> {
    const { library, editor } = this.#session;
    const keeping = library.keepSetting(setting);
    editor.saved(openedFrom(setting));
    await keeping;
    return !library.settings.unsaved.peek().has(setting.id);
  }
}

function openedFrom({ id, program }: Setting): { readonly id: string; readonly saved: TimerProgram } {
  return { id, saved: program };
}

function isStorable(program: TimerProgram): boolean {
  try {
    requireProgram(program);
    return true;
  } catch {
    return false;
  }
}
