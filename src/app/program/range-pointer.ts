import type { TargetedDragEvent, TargetedMouseEvent, TargetedPointerEvent } from 'preact';
import { useEffect, useMemo } from 'preact/hooks';
import type { GridCell } from '../editing/grid.js';
import type { Selection } from './selection.js';
import { cellOf } from './table-keys.js';

/** What a table listens to, so that a pointer selects in it. */
export interface RangePointer {
  readonly onMouseDown: (event: TargetedMouseEvent<HTMLTableElement>) => void;
  readonly onPointerDown: (event: TargetedPointerEvent<HTMLTableElement>) => void;
  readonly onDragStart: (event: TargetedDragEvent<HTMLTableElement>) => void;
}

/**
 * Cells are selected as in a spreadsheet: from the one that is pressed to the one under the mouse, or to the next one with Shift, or after
 * “Select range”. A finger scrolls.
 *
 * The range follows the pointer by where it is and not by what it enters: the text in a field is marked, and a browser that takes hold of
 * it would carry it to another cell, and tell of nothing on its way.
 */
export function useRangePointer(selection: Selection): RangePointer {
  const pointer = useMemo(() => rangePointer(selection), [selection]);
  useEffect(() => pointer.release, [pointer]);
  return pointer.listeners;
}

function rangePointer(selection: Selection): { readonly listeners: RangePointer; readonly release: () => void } {
  /** Ends the listening to the pointer that is down. */
  let release = (): void => {};

  const follow = (table: HTMLTableElement, pointerId: number): void => {
    const dragging = new AbortController();
    const { signal } = dragging;
    const move = (event: PointerEvent): void => {
      if (event.pointerId !== pointerId) return;
      // One without a field that has the focus would be a range that no key reaches.
      const cell = cellOf(document.activeElement) && cellUnder(table, event);
      const corner = selection.corner.value;
      if (cell && (cell.row !== corner?.row || cell.column !== corner.column)) selection.extendTo(cell);
      if (event.type !== 'pointermove' || (event.buttons & 1) === 0) dragging.abort();
    };
    release();
    release = () => dragging.abort();
    document.addEventListener('pointermove', move, { signal });
    // The last move may have been where it is let go; a release outside of the window is told of here, too.
    document.addEventListener('pointerup', move, { signal });
    document.addEventListener('pointercancel', ({ pointerId: id }) => id === pointerId && dragging.abort(), { signal });
  };

  const listeners: RangePointer = {
    onMouseDown: (event) => {
      const cell = cellOf(event.target);
      if (!cell || event.button !== 0) return;
      const isCorner = event.shiftKey || selection.picking.value;
      if (!isCorner || !selection.active.value) return selection.enter(cell);
      event.preventDefault();
      selection.extendTo(cell);
    },
    onPointerDown: (event) => {
      const { target, pointerType, pointerId, button, defaultPrevented } = event;
      if (defaultPrevented || pointerType !== 'mouse' || button !== 0 || selection.picking.value) return;
      if (!cellOf(target) || (target instanceof Element && target.closest('button'))) return;
      follow(event.currentTarget, pointerId);
    },
    onDragStart: (event) => event.preventDefault(),
  };
  return { listeners, release: () => release() };
}

/** The cell at which a pointer is, also below what hangs over it from another one; null outside of the table and under what covers it. */
function cellUnder(table: HTMLTableElement, { clientX, clientY }: PointerEvent): GridCell | null {
  for (const element of document.elementsFromPoint(clientX, clientY)) {
    if (!table.contains(element)) return null;
    if (element.matches('td[data-cell]')) return cellOf(element);
  }
  return null;
}
