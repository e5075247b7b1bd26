import type { Editor } from '../editing/editor.js';
import { type GridCell, gridColumns } from '../editing/grid.js';
import type { Selection } from './selection.js';
import { cellAt, cellOf } from './table-cells.js';

/** What the keys of the table work on. */
export interface TableKeys {
  readonly editor: Editor;
  readonly selection: Selection;
  readonly fillDown: () => void;
  /** Moves the focus to what can be done to a range. */
  readonly toBar: () => void;
}

const DIRECTIONS: Readonly<Record<string, readonly [down: number, right: number]>> = {
  ArrowUp: [-1, 0],
  ArrowDown: [1, 0],
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
};

/**
 * The keys of a spreadsheet: arrows and Enter move, Shift with an arrow extends the range, Tab goes from it to its
 * buttons, Ctrl+D fills down. Left and right move within a text until its end.
 */
export function onTableKey(event: KeyboardEvent, keys: TableKeys): void {
  const { target } = event;
  const cell = cellOf(target);
  if (event.defaultPrevented || event.altKey || !cell || !(target instanceof HTMLInputElement)) return;
  if (event.ctrlKey || event.metaKey) {
    if (event.key.toLowerCase() !== 'd' || event.shiftKey) return;
    event.preventDefault();
    keys.fillDown();
    return;
  }
  if (event.key === 'Escape' && keys.selection.isWide.value) {
    event.preventDefault();
    keys.selection.collapse();
    return;
  }
  if (event.key === 'Tab' && !event.shiftKey && keys.selection.isWide.value) {
    event.preventDefault();
    keys.toBar();
    return;
  }
  if (event.key === 'Enter') {
    moveFocus(event, target, cell, [event.shiftKey ? -1 : 1, 0]);
    return;
  }
  const direction = DIRECTIONS[event.key];
  if (!direction || (direction[1] !== 0 && !leavesText(target, direction[1]))) return;
  if (event.shiftKey) extend(event, target, keys, direction);
  else moveFocus(event, target, cell, direction);
}

/** Whether an arrow to the side has nothing left to do in the text. */
function leavesText({ selectionStart, selectionEnd, value }: HTMLInputElement, right: number): boolean {
  const isWhole = selectionStart === 0 && selectionEnd === value.length;
  const end = right > 0 ? value.length : 0;
  return isWhole || (selectionStart === end && selectionEnd === end);
}

/** To the next cell that way, which comes in sight; the focus stays. */
function extend(
  event: KeyboardEvent,
  from: HTMLInputElement,
  { editor, selection }: TableKeys,
  [down, right]: readonly [number, number],
): void {
  const identity = editor.working.value?.identity;
  const corner = selection.corner.value;
  if (!identity || !corner) return;
  event.preventDefault();
  const within = (at: number, last: number): number => Math.min(Math.max(at, 0), last);
  const next = {
    row: within(corner.row + down, identity.functions),
    column: within(corner.column + right, gridColumns(identity) - 1),
  };
  selection.extendTo(next);
  const table = from.closest('table');
  const cell = table && cellAt(table, next);
  const toSight = (): void => cell?.scrollIntoView({ block: 'nearest' });
  toSight();
  // The bar that a range brings is as high as it is only a frame later.
  requestAnimationFrame(() => requestAnimationFrame(toSight));
}

/** To the next cell that way which can be edited; at the edge the focus stays. */
function moveFocus(
  event: KeyboardEvent,
  from: HTMLInputElement,
  cell: GridCell,
  [down, right]: readonly [number, number],
): void {
  const table = from.closest('table');
  let { row, column } = cell;
  for (;;) {
    row += down;
    column += right;
    const found = table && cellAt(table, { row, column });
    if (!found) return;
    const input = found.querySelector('input');
    if (!input) continue;
    event.preventDefault();
    input.focus();
    return;
  }
}
