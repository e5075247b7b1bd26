import { signal } from '@preact/signals';
import type { ProgramField } from '../../program/index.js';
import type { Editor } from '../editing/editor.js';

/**
 * What has its tools open: the slot of a row; `start`, which has no time, so that 0 is the motor stop of a Q; or a
 * servo.
 */
export type ToolsPlace = number | 'start' | `servo-${number}`;

/** The tools of a row or a servo: which has them open, and how far to shift, which stays the same from row to row. */
export class RowTools {
  readonly editor: Editor;
  // Only this model writes them.
  /** Whose tools are open. */
  readonly open = signal<ToolsPlace | null>(null);
  /** How far to shift, as it was typed. */
  readonly amount = signal('0.10');
  readonly moveDt = signal(false);

  constructor(editor: Editor) {
    this.editor = editor;
  }

  show(place: ToolsPlace): void {
    this.open.value = place;
  }

  /**
   * Opens the tools of this field's row; without one, or at the start, those of the motor stop or else of function 1.
   */
  showFor(field: ProgramField | null): void {
    const slot = field && 'slot' in field ? field.slot : 0;
    const isStart = slot === 0 && this.editor.identity.value?.timerClass !== 'Q';
    this.show(isStart ? 1 : slot);
  }

  close(): void {
    this.open.value = null;
  }

  setAmount(text: string): void {
    this.amount.value = text;
  }

  setMoveDt(on: boolean): void {
    this.moveDt.value = on;
  }
}
