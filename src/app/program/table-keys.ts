import { shortcutLetter } from '../browser/shortcut-letter.js';
import { gridColumns } from '../editing/grid.js';
import { cellAt, cellOf } from './table-cells.js';
import type { TableModel } from './table-model.js';

/** The column with the tools of the rows, left of the times. Those of the servos are above their positions. */
const OPENERS = -1;

const DIRECTIONS: Readonly<Record<string, readonly [down: number, right: number]>> = {
  ArrowUp: [-1, 0],
  ArrowDown: [1, 0],
  ArrowLeft: [0, -1],
  ArrowRight: [0, 1],
};

/**
 * The keys of a spreadsheet: arrows and Enter move, Shift with an arrow extends the range, Tab goes to the buttons of
 * the range, Ctrl+D fills down, Ctrl+Up goes to the heading and keeps the range, Alt with an arrow steps, with Shift
 * ten steps at once. Left and right first move inside a text to its end.
 */
export function onTableKey(event: KeyboardEvent, table: TableModel): void {
  const { target, key } = event;
  if (event.defaultPrevented) return;
  const direction = DIRECTIONS[key];
  if (!event.altKey && target instanceof Element && target.matches('.row-opener')) {
    if (direction) moveFocus(event, target, direction);
    return;
  }
  const value = table.valueIn(target);
  if (!value || !(target instanceof HTMLInputElement)) return;
  if (event.altKey && direction?.[0] && !event.ctrlKey && !event.metaKey) {
    event.preventDefault();
    table.step(-direction[0] * (event.shiftKey ? 10 : 1));
    return;
  }
  if (key === 'Escape') value.escape();
  // First asks what was meant. Tab leads to the answers.
  const isDone = key === 'Enter' || (key === 'Tab' && !event.shiftKey && !value.face.value.either);
  if (isDone && !value.finish()) {
    event.preventDefault();
    return;
  }
  if (event.altKey || !cellOf(target)) return;
  if (event.ctrlKey || event.metaKey) {
    const heading =
      key === 'ArrowUp' && !event.shiftKey ? openerAt(target.closest('table')?.rows[0], columnOf(target)) : null;
    if (heading) {
      event.preventDefault();
      heading.focus();
      return;
    }
    if (shortcutLetter(event) !== 'd' || event.shiftKey) return;
    event.preventDefault();
    table.fillDown();
    return;
  }
  const isWide = table.selection.isWide.value;
  if (isWide && key === 'Escape') {
    event.preventDefault();
    table.selection.collapse();
    return;
  }
  if (isWide && key === 'Tab' && !event.shiftKey) {
    event.preventDefault();
    target.closest('.table-box')?.querySelector<HTMLElement>('.range-bar button')?.focus();
    return;
  }
  if (key === 'Enter') {
    moveFocus(event, target, [event.shiftKey ? -1 : 1, 0]);
    return;
  }
  if (!direction || (direction[1] !== 0 && !leavesText(target, direction[1]))) return;
  if (event.shiftKey) extend(event, target, table, direction);
  else moveFocus(event, target, direction);
}

/** Whether the arrow would leave the text. */
function leavesText({ selectionStart, selectionEnd, value }: HTMLInputElement, right: number): boolean {
  const isWhole = selectionStart === 0 && selectionEnd === value.length;
  const end = right > 0 ? value.length : 0;
  return isWhole || (selectionStart === end && selectionEnd === end);
}

/** Extends the range to the next cell in this direction and scrolls it into sight. The focus stays. */
function extend(
  event: KeyboardEvent,
  from: HTMLInputElement,
  { editor, selection }: TableModel,
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
  const element = from.closest('table');
  const cell = element && cellAt(element, next);
  const toSight = (): void => cell?.scrollIntoView({ block: 'nearest' });
  toSight();
  // The bar of the range has its final height only a frame later.
  requestAnimationFrame(() => requestAnimationFrame(toSight));
}

/**
 * Moves the focus to the next editable cell in this direction, as they stand on the screen. Left of the times are the
 * tools of the rows; hidden cells are skipped. At the edge the focus stays.
 */
function moveFocus(event: KeyboardEvent, from: Element, [down, right]: readonly [number, number]): void {
  let row = from.closest('tr');
  let column = columnOf(from);
  const columns = row?.closest('table')?.querySelectorAll('thead th').length ?? 0;
  for (;;) {
    if (row && down !== 0) row = rowBeside(row, down);
    column += right;
    if (!row || column < OPENERS || column >= columns) {
      // As in the cell that it would have gone to, what is typed next replaces the text.
      event.preventDefault();
      if (from instanceof HTMLInputElement) from.select();
      return;
    }
    const found = openerAt(row, column) ?? row.querySelector<HTMLElement>(`td[data-cell="${column}"] input`);
    found?.focus();
    if (!found || document.activeElement !== found) continue;
    event.preventDefault();
    return;
  }
}

/** The grid column of an element; that of the tools of the rows where it is in none. */
function columnOf(element: Element): number {
  return Number(element.closest('[data-cell]')?.getAttribute('data-cell') ?? OPENERS);
}

/** What opens the tools of a heading. */
function openerAt(row: Element | undefined, column: number): HTMLElement | null {
  const heading = column === OPENERS ? 'th[scope="row"]' : `th[data-cell="${column}"]`;
  return row?.querySelector<HTMLElement>(`${heading} .row-opener`) ?? null;
}

/** The next row of the program in this direction, or the headings above the first one. */
function rowBeside(row: HTMLTableRowElement, down: number): HTMLTableRowElement | null {
  const rows = [...(row.closest('table')?.rows ?? [])];
  const known = rows.filter((each) => each === row || each.matches('thead > tr, [data-slot]'));
  return known[known.indexOf(row) + down] ?? null;
}
