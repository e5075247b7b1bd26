import { batch, computed, type ReadonlySignal, signal } from '@preact/signals';
import { fieldKey, type ProgramField, type TimerProgram } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';
import { shiftFrom, slotsThatShift } from '../editing/edits.js';
import type { StepName } from '../editing/history.js';
import { parseInterval } from '../editing/units.js';
import { messages, obstacleText } from '../messages/index.js';

/**
 * What has its tools open: the slot of a row; `start`, which has no time, so that 0 is the motor stop of a Q; or a
 * servo.
 */
export type ToolsPlace = number | 'start' | `servo-${number}`;

/**
 * The tools of a row or a servo: which has them open, and how far to shift a row, which stays the same from row to row.
 */
export class RowTools {
  readonly #editor: Editor;
  readonly #open = signal<ToolsPlace | null>(null);
  readonly #amount = signal('0.10');
  readonly #moveDt = signal(false);
  /** The program when the tools were opened. */
  readonly #before = signal<TimerProgram | null>(null);
  readonly #problem = signal<(() => string) | null>(null);

  /** Whose tools are open. */
  readonly open: ReadonlySignal<ToolsPlace | null> = this.#open;
  /** How far to shift, as it was typed. */
  readonly amount: ReadonlySignal<string> = this.#amount;
  readonly moveDt: ReadonlySignal<boolean> = this.#moveDt;
  /** How far everything has moved since the tools were opened, in hundredths of a second. */
  readonly moved: ReadonlySignal<number> = computed(() => {
    const slot = this.#open.value;
    const step = this.#editor.undoStep.value;
    if (typeof slot !== 'number' || step?.code !== 'shift') return 0;
    const { slot: from } = step.params;
    if (from !== slot) return 0;
    return (this.#editor.working.value?.times[slot] ?? 0) - (this.#before.value?.times[slot] ?? 0);
  });
  /** The slots that a shift would move. */
  readonly moving: ReadonlySignal<readonly number[]> = computed(() => {
    const slot = this.#open.value;
    const working = this.#editor.working.value;
    if (typeof slot !== 'number' || !working) return [];
    return slotsThatShift(working, slot, { moveDt: this.#moveDt.value });
  });
  readonly problem: ReadonlySignal<string | null> = computed(() => this.#problem.value?.() ?? null);

  constructor(editor: Editor) {
    this.#editor = editor;
  }

  show(place: ToolsPlace): void {
    batch(() => {
      this.#open.value = place;
      this.#before.value = this.#editor.working.peek();
      this.#problem.value = null;
    });
  }

  /**
   * Opens the tools of this field's row; without one, or at the start, those of the motor stop or else of function 1.
   */
  showFor(field: ProgramField | null): void {
    const slot = field && 'slot' in field ? field.slot : 0;
    const isStart = slot === 0 && this.#editor.identity.value?.timerClass !== 'Q';
    this.show(isStart ? 1 : slot);
  }

  close(): void {
    this.#open.value = null;
  }

  setAmount(text: string): void {
    this.#amount.value = text;
    this.#problem.value = null;
  }

  setMoveDt(on: boolean): void {
    this.#moveDt.value = on;
  }

  /** Whether one of these values differs from the timer. */
  isChanged(fields: readonly ProgramField[]): boolean {
    const { changed, unreadable } = this.#editor;
    return fields.map(fieldKey).some((key) => changed.value.has(key) || unreadable.value.has(key));
  }

  /** Puts the values of a row back to what the timer holds. */
  putBack(slot: number, fields: readonly ProgramField[]): void {
    const [field, ...others] = fields;
    const params: StepName['params'] = field && others.length === 0 ? { field: fieldKey(field) } : { slot };
    this.#editor.revertFields({ code: 'change', params }, fields);
  }

  /** Moves the open slot and all later ones by the typed amount, to later or to earlier. */
  shift(direction: 1 | -1): void {
    const parsed = parseInterval(this.#amount.value);
    if ('unreadable' in parsed) {
      this.#problem.value = () => messages.value.unreadable[parsed.unreadable];
      return;
    }
    const slot = this.#open.value;
    const working = this.#editor.working.value;
    if (typeof slot !== 'number' || !working) return;
    const obstacle = this.#editor.apply(
      shiftFrom(working, slot, direction * parsed.value, { moveDt: this.#moveDt.value }),
    );
    const { identity } = working;
    this.#problem.value = obstacle && (() => `${messages.value.edits.nothingDone} ${obstacleText(identity, obstacle)}`);
  }
}
