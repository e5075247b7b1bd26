import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import { NOBODY, type Owner, replaceAll } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { isOfOneShape } from '../editing/shape.js';
import type { Backup, Draft } from '../storage/index.js';
import type { Knowledge } from '../timer/knowledge.js';
import type { Notices } from '../timer/notices.js';
import { programKey } from '../timer/record-keys.js';
import type { Drafts } from './drafts.js';
import type { Origin } from './origin.js';

interface OnScreenParts {
  readonly editor: Editor;
  readonly origin: Origin;
  readonly knowledge: Knowledge;
  readonly notices: Notices;
  readonly drafts: Drafts;
  readonly connection: ReadonlySignal<unknown>;
  readonly engaged: ReadonlySignal<boolean>;
}

/** The program on the screen, and what comes there at the pilot's wish. For readings see `Reader`. */
export class OnScreen {
  readonly #simulated = signal(false, { name: 'simulated' });
  /** Whether it comes from the simulated timer. */
  readonly simulated: ReadonlySignal<boolean> = this.#simulated;
  /** The memory that it is of, counted from 0; null when it is of none, or the timer does not say. */
  readonly memory: ReadonlySignal<number | null>;
  readonly #apart = signal(false, { name: 'apart' });
  /**
   * Whether the pilot has opened it there without making it fly next. It stays on the screen when the memory that does
   * is read. Nothing about the next flight comes from it: for that see `NextFlight` and `Standings.next`.
   */
  readonly apart: ReadonlySignal<boolean> = this.#apart;
  readonly #parts: OnScreenParts;

  constructor(parts: OnScreenParts) {
    this.#parts = parts;
    this.memory = computed(() => parts.editor.working.value?.memory ?? null);
  }

  /**
   * Shows a program that was made on this device, to edit without a timer.
   * @param from the setting that it is opened from, or the model whose backup it is.
   */
  make(program: TimerProgram, from?: Owner): void {
    if (!this.closeProgram()) return;
    batch(() => {
      this.#parts.editor.make(program, from);
      this.#simulated.value = false;
    });
  }

  /**
   * Clears the screen for something else, while no timer is connected. The pilot's changes are kept.
   * @returns whether it is clear.
   */
  closeProgram(): boolean {
    if (!this.#isFree()) return false;
    this.#parts.notices.dismiss();
    this.clear();
    return true;
  }

  /** Shows a stored draft, as a program of no timer. */
  showKept(draft: Draft): void {
    if (this.closeProgram()) this.bringBack(this.#parts.drafts.take(draft));
  }

  /** Brings a draft back to an empty screen. */
  bringBack(draft: Draft): void {
    const { editor, knowledge, notices, origin } = this.#parts;
    // In one step: in between it must not be kept as work on a real timer.
    batch(() => {
      if (!editor.restore(draft)) return;
      this.#simulated.value = draft.simulated;
      this.#apart.value = draft.apart ?? false;
      origin.take(draft.model);
      if (typeof draft.readAt === 'number') knowledge.remember(draft.baseline, draft.readAt);
      // A program that is in no timer differs from none: the line at the top says what it is.
      if (draft.madeAt === undefined) notices.sayIfSilent('back');
    });
  }

  /**
   * Whether a backup can come to the screen: over the present program or, while no timer is connected, in its place.
   */
  canLoad(program: TimerProgram): boolean {
    return this.#takes(program) || this.#isFree();
  }

  /** Takes the values of a backup as what the pilot wants. Writes nothing. */
  showBackup({ program, model }: Pick<Backup, 'program'> & Partial<Backup>): void {
    if (this.#takes(program)) {
      const edit = replaceAll({ code: 'open', params: {} }, program);
      // It is no setting any more: to save it over one, the pilot has to say so.
      this.#parts.editor.apply({ ...edit, owner: { of: undefined, backupOf: model ?? NOBODY } });
    } else {
      this.make({ ...program, memory: null }, { backupOf: model ?? NOBODY });
    }
  }

  /** Clears the screen. The pilot's changes are kept. */
  clear(): void {
    const { editor, drafts } = this.#parts;
    const madeAt = editor.madeAt.value;
    if (madeAt !== null) drafts.shelve(madeAt);
    batch(() => {
      this.#apart.value = false;
      editor.clear();
    });
  }

  /** The key of such a program, from the same timer as the one on the screen: see `programKey`. */
  keyOf(program: TimerProgram): string {
    return programKey(program, this.#simulated.value);
  }

  /**
   * @param simulated whether the last reading was of the simulated timer.
   * @param apart see {@link apart}.
   */
  wasRead(simulated: boolean, apart: boolean): void {
    batch(() => {
      this.#simulated.value = simulated;
      this.#apart.value = apart;
    });
  }

  /** Whether the present program can have the values of this one. */
  #takes({ identity }: TimerProgram): boolean {
    const working = this.#parts.editor.working.value;
    return working !== null && isOfOneShape(working.identity, identity);
  }

  /** Whether no timer is connected or being connected. */
  #isFree(): boolean {
    return !this.#parts.engaged.value && this.#parts.connection.value === null;
  }
}
