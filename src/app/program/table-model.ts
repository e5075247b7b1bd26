import { computed, effect, type ReadonlySignal, signal } from '@preact/signals';
import type { ProgramField, TimerProgram } from '../../program/index.js';
import { copiedText } from '../browser/clipboard.js';
import { media } from '../browser/doors.js';
import { attempt } from '../browser/services.js';
import { formatTable } from '../editing/clipboard-table.js';
import type { Edit, TextOption } from '../editing/edit.js';
import type { Editor } from '../editing/editor.js';
import { fillDown, stepRange } from '../editing/edits.js';
import { type GridCell, type GridRange, motorRow } from '../editing/grid.js';
import { messages, obstacleText } from '../messages/index.js';
import type { EditedValue } from '../work/edited-value.js';
import { Hand } from './hand.js';
import { Selection } from './selection.js';
import { cellOf } from './table-cells.js';

/** A text to paste, and where. */
export interface Pasting {
  readonly range: GridRange;
  readonly text: string;
}

/** A hand needs about as long from the keys to the mouse: what moves then has moved before it aims. In milliseconds. */
const REST = 400;

/** The table on the screen: the field in hand, the selected cells, and what is done to them. */
export class TableModel {
  readonly editor: Editor;
  readonly selection = new Selection();
  readonly hand = new Hand(media('(pointer: coarse)')?.matches ?? false);
  /** The field whose handle is used in the timeline. */
  readonly marked: ReadonlySignal<ProgramField | null>;

  readonly #motorDue = computed(() => this.editor.working.value && motorRow(this.editor.working.value));
  readonly #motorHeld = signal<number | null>(null);
  /** The slot before whose row the motor stop of a Q stands: see {@link motorRow}. Held while the table is in use. */
  readonly motorBefore: ReadonlySignal<number | null> = computed(() => {
    const due = this.#motorDue.value;
    return due === null ? null : (this.#motorHeld.value ?? due);
  });

  // Only this model writes them.
  /** Changes when nothing has been edited for a while: the pilot's hands rest. */
  readonly rested = signal<unknown>(null);
  /** What to paste, once the pilot has looked at it. */
  readonly pasting = signal<Pasting | null>(null);
  /** Whether intervals are shown in place of times, where there is no room for both. */
  readonly byIntervals = signal(false);
  readonly #obstacle = signal<(() => string) | null>(null);
  /** Why the selected cells were not changed. */
  readonly obstacle: ReadonlySignal<string | null> = computed(() => this.#obstacle.value?.() ?? null);

  constructor(editor: Editor, marked: ReadonlySignal<ProgramField | null>) {
    this.editor = editor;
    this.marked = marked;
  }

  /** Follows what the pilot works with, and when the hands rest. @returns a function that ends this. */
  follow(): () => void {
    const { working, unreadable, asked, findings } = this.editor;
    const endHand = this.hand.follow(document);
    const endRest = effect(() => {
      const edited = [working.value, unreadable.value, asked.value, findings.value];
      const rest = setTimeout(() => {
        this.rested.value = edited;
      }, REST);
      return () => clearTimeout(rest);
    });
    return () => {
      endHand();
      endRest();
    };
  }

  /** Something in the table got the focus; null when that is no cell. No row moves under the finger. */
  entered(cell: GridCell | null): void {
    this.#obstacle.value = null;
    this.#motorHeld.value = cell ? this.#motorDue.value : this.motorBefore.value;
  }

  /** Shows intervals in place of times, or the times again. */
  switchColumn(): void {
    this.byIntervals.value = !this.byIntervals.value;
  }

  /** The focus has left the table. */
  left(): void {
    this.#motorHeld.value = null;
  }

  /** The pilot needs the range no longer. */
  done(): void {
    this.selection.collapse();
    this.#obstacle.value = null;
  }

  /** The value that is edited in an element of the table; null where it is not the field in hand. */
  valueIn(target: EventTarget | null): EditedValue | null {
    const { value: held } = this.hand.held;
    return held?.input === target ? held.value : null;
  }

  /** Steps the field in hand, or all selected cells. @param by steps up; negative: down. */
  step(by: number): void {
    const { value: held } = this.hand.held;
    const isInRange = this.selection.isWide.value && cellOf(held?.input ?? null) !== null;
    if (isInRange) this.#edit((working, range, texts) => stepRange(working, range, by, texts));
    else held?.value.step(by);
  }

  /** Copies the first row of the range into its others. A single cell takes the value of the cell above it. */
  fillDown(): void {
    this.#edit((working, range, texts) => {
      const top = range.top === range.bottom ? Math.max(0, range.top - 1) : range.top;
      return fillDown(working, { ...range, top }, texts);
    });
  }

  #edit(make: (working: TimerProgram, range: GridRange, texts: TextOption) => Edit): void {
    const { working, unreadable } = this.editor;
    const range = this.selection.range.value;
    if (!range || !working.value) return;
    const found = this.editor.apply(make(working.value, range, { unreadable: unreadable.value }));
    const { identity } = working.value;
    this.#obstacle.value = found && (() => obstacleText(identity, found));
  }

  /** The selected cells, for other programs. */
  selectedText(): string {
    const { working } = this.editor;
    const range = this.selection.range.value;
    return range && working.value ? formatTable(working.value, range) : '';
  }

  /** Also for Cut: no cell of a program can be empty. In the text of one field the browser copies and cuts. */
  copy(event: ClipboardEvent): void {
    if (isElsewhere(event) || !this.selection.isWide.value || !event.clipboardData) return;
    event.preventDefault();
    event.clipboardData.setData('text/plain', this.selectedText());
  }

  paste(event: ClipboardEvent): void {
    if (isElsewhere(event)) return;
    const text = event.clipboardData?.getData('text/plain') ?? '';
    const range = this.selection.range.value;
    if (!range || text === '') return;
    this.#obstacle.value = null;
    // One value into one cell counts as typing. Empty cells would only empty the field.
    if (text.trim() !== '' && !this.selection.isWide.value && !/[\t\r\n;]./.test(text)) return;
    event.preventDefault();
    this.#offer(range, text);
  }

  /** Pastes by a button. The browser may be asking the pilot; an answer that comes later is welcome, too. */
  async pasteCopied(): Promise<void> {
    const range = this.selection.range.value;
    this.#obstacle.value = null;
    const asked = copiedText().then((text) => this.#offer(range, text));
    await attempt(() => asked).catch(() => this.#offer(range, ''));
  }

  #offer(range: GridRange | null, text: string): void {
    const isSome = range !== null && text.trim() !== '';
    this.#obstacle.value = isSome ? null : () => messages.value.edits.table.range.clipboardClosed;
    if (isSome) this.pasting.value = { range, text };
  }

  /** The text was pasted, or is not wanted. */
  pasted(): void {
    this.pasting.value = null;
  }
}

/** Whether somebody works in a field that is no cell, as that of the tools, which hang in the table. */
function isElsewhere({ target }: ClipboardEvent): boolean {
  return target instanceof HTMLInputElement && cellOf(target) === null;
}
