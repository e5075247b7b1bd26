import { batch, type ReadonlySignal, signal } from '@preact/signals';
import type { ProgramField } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';
import { shiftFrom } from '../editing/edits.js';
import { parseInterval } from '../editing/units.js';
import { messages, obstacleText } from '../messages/index.js';

/** The tools of a row: which one has them open, and what its shift is set to. The setting stays from row to row. */
export class RowTools {
  readonly #editor: Editor;
  readonly #open = signal<number | 'start' | null>(null);
  readonly #amount = signal('0.10');
  readonly #moveDt = signal(false);
  readonly #moved = signal(0);
  readonly #problem = signal<string | null>(null);

  /** The slot whose tools are open; 0 is the motor stop on a Q, beside which the start has no time. */
  readonly open: ReadonlySignal<number | 'start' | null> = this.#open;
  /** By how much is shifted, as it was typed. */
  readonly amount: ReadonlySignal<string> = this.#amount;
  readonly moveDt: ReadonlySignal<boolean> = this.#moveDt;
  /** How far all was shifted since the tools were opened, in hundredths of a second. */
  readonly moved: ReadonlySignal<number> = this.#moved;
  readonly problem: ReadonlySignal<string | null> = this.#problem;

  constructor(editor: Editor) {
    this.#editor = editor;
  }

  show(slot: number | 'start'): void {
    batch(() => {
      this.#open.value = slot;
      this.#moved.value = 0;
      this.#problem.value = null;
    });
  }

  /** Those of the row in hand; with none, or at the start, those of the motor stop or, without one, of function 1. */
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

  /** Moves the open slot and all after it by the amount, to later or to earlier. */
  shift(direction: 1 | -1): void {
    const slot = this.#open.value;
    const working = this.#editor.working.value;
    if (typeof slot !== 'number' || !working) return;
    const parsed = parseInterval(this.#amount.value);
    if ('unreadable' in parsed) {
      this.#problem.value = messages.value.unreadable[parsed.unreadable];
      return;
    }
    const by = direction * parsed.value;
    const obstacle = this.#editor.apply(shiftFrom(working, slot, by, { moveDt: this.#moveDt.value }));
    const { nothingDone } = messages.value.edits;
    this.#problem.value = obstacle && `${nothingDone} ${obstacleText(working.identity, obstacle)}`;
    if (!obstacle) this.#moved.value += by;
  }
}
