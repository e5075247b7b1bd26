import { batch, type ReadonlySignal, signal } from '@preact/signals';
import type { TimerProgram } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import type { Content } from '../editing/content.js';
import { replaceAll } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { isOfOneShape } from '../editing/shape.js';
import type { Backup, Draft } from '../storage/index.js';
import type { Drafts } from './drafts.js';
import type { Knowledge } from './knowledge.js';
import type { Notices } from './notices.js';
import type { Origin } from './origin.js';

interface OnScreenParts {
  readonly editor: Editor;
  readonly knowledge: Knowledge;
  readonly notices: Notices;
  readonly connection: ReadonlySignal<TimerConnection | null>;
  /** Something is under way, or waited for. */
  readonly engaged: ReadonlySignal<boolean>;
  readonly origin: Origin;
}

/** The program on the screen, and what comes there by the pilot's wish: no reading, see `Reader`. */
export class OnScreen {
  readonly #simulated = signal(false, { name: 'simulated' });
  /** Whether it is of the simulated timer. */
  readonly simulated: ReadonlySignal<boolean> = this.#simulated;
  readonly #parts: OnScreenParts;
  readonly #drafts: Drafts;

  constructor(parts: OnScreenParts, drafts: Drafts) {
    this.#parts = parts;
    this.#drafts = drafts;
  }

  /**
   * A program that was made on this device comes to the screen, to be edited without a timer.
   * @param from the setting that it is opened from, or the model whose backup it is.
   */
  make(program: TimerProgram, from?: Partial<Pick<Content, 'of' | 'backupOf'>>): void {
    if (!this.#isFree()) return;
    this.#parts.notices.dismiss();
    this.clear();
    batch(() => {
      this.#parts.editor.make(program, from);
      this.#simulated.value = false;
    });
  }

  /** Clears the screen for something else, while no timer is connected. What the pilot wants is kept. */
  putAway(): void {
    if (!this.#isFree()) return;
    this.#parts.notices.dismiss();
    this.clear();
  }

  /** Shows what was kept of earlier work, as the program of no timer. */
  showKept(draft: Draft): void {
    if (!this.#isFree()) return;
    this.#parts.notices.dismiss();
    this.clear();
    this.bringBack(this.#drafts.take(draft));
  }

  /** What was kept comes back to a screen on which nothing is. */
  bringBack(draft: Draft): void {
    const { editor, knowledge, notices, origin } = this.#parts;
    // At one stroke: it must not be kept as the work on a real timer in between.
    batch(() => {
      if (!editor.restore(draft)) return;
      this.#simulated.value = draft.simulated;
      origin.take(draft.model);
      if (typeof draft.readAt === 'number') knowledge.remember(draft.baseline, draft.readAt);
      notices.sayIfSilent(draft.madeAt === undefined ? 'edits-restored' : 'made-restored');
    });
  }

  /** Whether a backup can come to the screen: over what is there, or, while no timer is connected, in its place. */
  canLoad(program: TimerProgram): boolean {
    const working = this.#parts.editor.working.value;
    return (working !== null && isOfOneShape(working.identity, program.identity)) || this.#isFree();
  }

  /** What was kept becomes what the pilot wants; nothing is written. */
  showBackup({ program, model }: Backup): void {
    if (!this.canLoad(program)) return;
    const { editor } = this.#parts;
    const working = editor.working.value;
    if (!working || !isOfOneShape(working.identity, program.identity)) {
      this.make({ ...program, memory: null }, { backupOf: model });
      return;
    }
    const idleThrottle = program.idleThrottle ?? working.idleThrottle;
    const wanted = { ...working, times: program.times, positions: program.positions, idleThrottle };
    editor.apply({ ...replaceAll({ code: 'restore', params: {} }, wanted), backupOf: model });
  }

  /** Nothing is on the screen any more. What the pilot wants is kept. */
  clear(): void {
    const { editor } = this.#parts;
    const madeAt = editor.madeAt.value;
    if (madeAt !== null) this.#drafts.shelve(madeAt);
    editor.clear();
  }

  /** Under what the work on such a program is kept, from the timer that the one on the screen came from. */
  workKey(program: TimerProgram): string {
    return this.#drafts.keyOf(program, this.#simulated.value);
  }

  /** @param simulated whether what was read just now is of the simulated timer. */
  wasRead(simulated: boolean): void {
    this.#simulated.value = simulated;
  }

  /** Whether the screen is the pilot's alone: no timer is connected, or on its way. */
  #isFree(): boolean {
    return !this.#parts.engaged.value && this.#parts.connection.value === null;
  }
}
