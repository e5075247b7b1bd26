import type { GridCell } from '../editing/grid.js';

/** The grid place of an element in the table; null outside of its cells. */
export function cellOf(target: EventTarget | null): GridCell | null {
  const cell = target instanceof Element ? target.closest('td[data-cell]') : null;
  const row = cell?.closest('tr[data-slot]')?.getAttribute('data-slot');
  return cell && row ? { row: Number(row), column: Number(cell.getAttribute('data-cell')) } : null;
}

/** The element at a grid place. */
export function cellAt(table: Element, { row, column }: GridCell): Element | null {
  return table.querySelector(`tr[data-slot="${row}"] td[data-cell="${column}"]`);
}

/**
 * The cell under a pointer, also below something that hangs over it from another cell. Null outside of the table, and
 * under anything that covers the table.
 */
export function cellUnder(table: Element, { clientX, clientY }: PointerEvent): GridCell | null {
  for (const element of document.elementsFromPoint(clientX, clientY)) {
    if (!table.contains(element)) return null;
    // The motor stop is the time of the start, wherever its row stands, so no range can reach it from here.
    if (element.closest('.motor-stop')) return null;
    if (element.matches('td[data-cell]')) return cellOf(element);
  }
  return null;
}

export function isSameCell(one: GridCell | null, other: GridCell | null): boolean {
  return one?.row === other?.row && one?.column === other?.column;
}
