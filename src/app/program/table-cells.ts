import type { GridCell } from '../editing/grid.js';

/** Where in the grid something of the table stands; null outside of its cells. */
export function cellOf(target: EventTarget | null): GridCell | null {
  const cell = target instanceof Element ? target.closest('td[data-cell]') : null;
  const row = cell?.closest('tr[data-slot]')?.getAttribute('data-slot');
  return cell && row ? { row: Number(row), column: Number(cell.getAttribute('data-cell')) } : null;
}

/** What stands in the table at a place of the grid. */
export function cellAt(table: Element, { row, column }: GridCell): Element | null {
  return table.querySelector(`tr[data-slot="${row}"] td[data-cell="${column}"]`);
}

/**
 * The cell at which a pointer is, also below what hangs over it from another one; null outside of the table and under
 * what covers it.
 */
export function cellUnder(table: Element, { clientX, clientY }: PointerEvent): GridCell | null {
  for (const element of document.elementsFromPoint(clientX, clientY)) {
    if (!table.contains(element)) return null;
    // The motor stop is the time of the start, wherever its row stands: no range goes over it to there.
    if (element.closest('.motor-stop')) return null;
    if (element.matches('td[data-cell]')) return cellOf(element);
  }
  return null;
}

export function isSameCell(one: GridCell | null, other: GridCell | null): boolean {
  return one?.row === other?.row && one?.column === other?.column;
}
