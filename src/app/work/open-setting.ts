import { computed, type ReadonlySignal, signal } from '@preact/signals';
import {
  requireProgram,
  type Setting,
  type SettingVersion,
  sameLayout,
  type TimerProgram,
} from '../../program/index.js';
import { changesSince } from '../editing/content.js';
import { type Owner, replaceAll } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { isOfOneShape } from '../editing/shape.js';
import { type Library, newId } from '../records/library.js';
import type { SettingRecord } from '../storage/index.js';
import type { Standings } from '../timer/standing.js';
import type { Drafts } from './drafts.js';
import type { OnScreen } from './on-screen.js';
import type { Origin } from './origin.js';

interface OpenSettingParts {
  readonly editor: Editor;
  readonly library: Library;
  readonly origin: Origin;
  readonly standings: Standings;
  readonly onScreen: OnScreen;
  readonly drafts: Drafts;
  readonly connection: ReadonlySignal<unknown>;
  readonly engaged: ReadonlySignal<boolean>;
}

/**
 * Why a setting cannot be shown now.
 * - `busy`: a job has the wire, or the page looks for a timer.
 * - `following`: the servos follow edits.
 * - `not-fitting`: the connected timer has another class or layout.
 */
export type ShowObstacle = 'busy' | 'following' | 'not-fitting';

/** How the program on the screen differs from the setting that it belongs to. */
export interface Unsaved {
  /** How many values differ from the library. */
  readonly changes: number;
  /** How many fields have a text that is no value. */
  readonly unreadable: number;
}

/** What a save has done. */
interface LastSave {
  readonly setting: Setting;
  /** What it has replaced; null when it was a new one. */
  readonly replaced: SettingRecord | null;
  /** Whether the screen has followed: it had no changes of its own. */
  readonly followed: boolean;
  /** Whose the values on the screen were before. */
  readonly before: Owner;
}

/** The name of a new setting, and where it goes. */
export interface NewSetting extends Pick<Setting, 'model' | 'name'>, Partial<Pick<Setting, 'note' | 'tags'>> {
  /** The setting that it replaces, if it is not new after all. What it does not say stays as it is there. */
  readonly over?: Setting | null;
}

/** The setting of the library that the program on the screen belongs to: opening it, and saving it. */
export class OpenSetting {
  /** Null when no setting is open. */
  readonly unsaved: ReadonlySignal<Unsaved | null>;
  /** Whether the program on the screen can be saved: each field has a value that a timer can hold. */
  readonly savable: ReadonlySignal<boolean>;
  /** The setting that was saved last, as long as that can be taken back; null when it cannot. */
  readonly undoable: ReadonlySignal<Setting | null>;
  readonly #last = signal<LastSave | null>(null, { name: 'lastSave' });
  readonly #parts: OpenSettingParts;
  #following: ReadonlySignal<boolean> | null = null;

  constructor(parts: OpenSettingParts) {
    this.#parts = parts;
    const { editor, origin } = parts;
    this.unsaved = computed(() => {
      const working = editor.working.value;
      const held = origin.setting.value?.program;
      if (!working || !held) return null;
      const changes = sameLayout(held.identity, working.identity) ? changesSince(held, working).length : Infinity;
      return { changes, unreadable: editor.unreadable.value.size };
    });
    this.savable = computed(() => {
      const working = editor.working.value;
      return working !== null && editor.unreadable.value.size === 0 && isStorable(working);
    });
    this.undoable = computed(() => {
      const last = this.#last.value?.setting;
      // Not once it has changed again, or something else is on the screen.
      const now = origin.setting.value;
      const isHere = last && now && now.id === last.id && now.at === last.at;
      return isHere && isSame(now.program, last.program) ? now : null;
    });
  }

  /** Shows no setting while this is true: the servos would move with it. */
  notWhile(following: ReadonlySignal<boolean>): void {
    this.#following = following;
  }

  /** Why a program cannot come to the screen now; null when it can. */
  obstacle(program: TimerProgram): ShowObstacle | null {
    const { connection, engaged, editor } = this.#parts;
    if (engaged.value) return 'busy';
    if (!connection.value) return null;
    if (this.#following?.value) return 'following';
    const held = editor.baseline.value;
    if (!held) return 'busy';
    return isOfOneShape(program.identity, held.identity) ? null : 'not-fitting';
  }

  /**
   * Opens a setting. Without a timer: to edit it, with its stored unsaved changes if there are any. With a connected
   * timer: over what the timer holds, as one step.
   * @returns whether it is shown.
   */
  async show(setting: Setting): Promise<boolean> {
    if (this.obstacle(setting.program)) return false;
    const { editor, connection, onScreen, drafts } = this.#parts;
    if (connection.value) return this.#layOver(setting);
    if (editor.of.value?.id === setting.id && editor.madeAt.value !== null) return true;
    const kept = await drafts.ofSetting(setting.id);
    // A timer may have come in the meantime.
    if (this.obstacle(setting.program) || connection.value) return false;
    // It belongs to no memory, so nothing that is known about a memory applies to it.
    if (kept) onScreen.showKept(kept);
    else onScreen.make({ ...setting.program, memory: null }, ownerBy(setting));
    return true;
  }

  /**
   * Saves the program on the screen as the open setting.
   * @returns whether the browser has stored it. It is in the library in any case.
   */
  async save(): Promise<boolean> {
    const setting = this.#parts.origin.setting.peek();
    const program = this.#program();
    if (!setting || !program) return false;
    return await this.#keep({ ...setting, program, ...this.source() });
  }

  /**
   * Saves the program on the screen as a new setting, or over another one, which is then open.
   * @returns whether the browser has stored it. It is in the library in any case.
   */
  async saveAs({ model, name, note = '', tags = [], over = null }: NewSetting): Promise<boolean> {
    const program = this.#program();
    if (!program) return false;
    const old = over ?? { id: newId(), note: '', tags };
    const said = { model, name, note: note || old.note };
    return await this.#keep({ ...old, ...said, program, archived: false, ...this.source() });
  }

  /**
   * Saves an earlier version of a setting over it. If the screen shows that setting without changes, it follows; what
   * was typed stays.
   */
  async goBack(setting: Setting, { program, at, from }: SettingVersion): Promise<void> {
    const back = { ...setting, program, at, from };
    if (this.#parts.origin.setting.peek()?.id !== setting.id) await this.#parts.library.keepSetting(back);
    else await this.#keep(back, this.#canFollow(program));
  }

  /** Brings the values of the open setting back to the screen, as one step. */
  loadAgain(): void {
    const { editor, origin } = this.#parts;
    const setting = origin.setting.peek();
    const working = editor.working.peek();
    if (setting && working && sameLayout(setting.program.identity, working.identity)) this.#layOver(setting);
  }

  /**
   * Where the values on the screen come from, and when they were last read or changed. A date of which nobody has read
   * the timer is the date of typing, never that of a reading.
   */
  source(): Pick<Setting, 'from' | 'at'> {
    const { editor, onScreen, origin, standings } = this.#parts;
    const saved = origin.setting.peek();
    if (saved && this.unsaved.peek()?.changes === 0) return { from: saved.from, at: saved.at };
    const { at: readAt } = standings.screen.peek();
    const isRead = editor.baseline.peek() !== null && standings.sinceRead.peek().length === 0;
    if (!isRead || editor.unreadable.peek().size > 0 || readAt === null) {
      return { from: 'typed', at: Date.now() };
    }
    return { from: onScreen.simulated.peek() ? 'simulated' : 'timer', at: readAt };
  }

  #layOver(setting: Setting): boolean {
    const name = { code: 'open', params: { name: setting.name } } as const;
    return this.#parts.editor.apply({ ...replaceAll(name, setting.program), owner: ownerBy(setting) }) === null;
  }

  #program(): TimerProgram | null {
    return this.savable.peek() ? this.#parts.origin.program.peek() : null;
  }

  /** Whether the screen shows the open setting as it is saved, and can show this program in its place. */
  #canFollow(program: TimerProgram): boolean {
    const { changes, unreadable } = this.unsaved.peek() ?? { changes: 1, unreadable: 0 };
    return changes + unreadable === 0 && this.obstacle(program) === null;
  }

  async #keep(setting: Setting, followed = false): Promise<boolean> {
    const { library, editor } = this.#parts;
    const before = { of: editor.of.peek(), backupOf: editor.backupOf.peek() };
    const replaced = library.settings.get(setting.id) ?? null;
    const keeping = library.keepSetting(setting);
    editor.saved(ownerBy(setting));
    if (followed) this.loadAgain();
    this.#last.value = { setting, replaced, followed, before };
    await keeping;
    return !library.settings.unsaved.peek().has(setting.id);
  }

  /** Takes the last save back: what it replaced is in the library again, and the screen is as changed as before. */
  undoSave(): void {
    const { library, editor } = this.#parts;
    const last = this.#last.peek();
    if (!last || !this.undoable.peek()) return;
    this.#last.value = null;
    const { setting, versions } = last.replaced ?? {};
    const follows = last.followed && setting !== undefined && this.#canFollow(setting.program);
    if (setting) void library.keepSetting(setting, { versions });
    else library.settings.remove(last.setting.id);
    editor.saved(setting ? ownerBy(setting) : last.before);
    if (follows) this.loadAgain();
  }
}

function ownerBy({ id, program }: Setting): Owner {
  return { of: { id, saved: program }, backupOf: undefined };
}

function isSame(a: TimerProgram, b: TimerProgram): boolean {
  return sameLayout(a.identity, b.identity) && changesSince(a, b).length === 0;
}

function isStorable(program: TimerProgram): boolean {
  try {
    requireProgram(program);
    return true;
  } catch {
    return false;
  }
}
