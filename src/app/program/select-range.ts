import type { TargetedDragEvent, TargetedFocusEvent, TargetedMouseEvent, TargetedPointerEvent } from 'preact';
import { useEffect, useMemo, useRef } from 'preact/hooks';
import type { GridCell } from '../editing/grid.js';
import { cellOf, cellUnder, isSameCell } from './table-cells.js';
import { onTableKey, type TableKeys } from './table-keys.js';

/** The listeners of a table by which cells are selected with mouse, finger and keys. */
export interface RangeListeners {
  readonly onKeyDown: (event: KeyboardEvent) => void;
  readonly onFocusIn: (event: TargetedFocusEvent<HTMLTableElement>) => void;
  readonly onInput: () => void;
  readonly onMouseDown: (event: TargetedMouseEvent<HTMLTableElement>) => void;
  readonly onPointerDown: (event: TargetedPointerEvent<HTMLTableElement>) => void;
  readonly onDragStart: (event: TargetedDragEvent<HTMLTableElement>) => void;
}

interface RangeUser extends TableKeys {
  /** Called when something in the table gets the focus. Null when that is no cell. */
  readonly onFocus: (cell: GridCell | null) => void;
}

/**
 * Selects cells as in a spreadsheet: from the pressed cell to the one under the mouse, or to the next one with Shift or
 * after “Select range”; with the keyboard by Shift and an arrow. A finger scrolls, so it selects with two taps.
 */
export function useSelectRange(user: RangeUser): RangeListeners {
  const latest = useRef(user);
  latest.current = user;
  const { listeners, stop } = useMemo(() => selectRange(() => latest.current), []);
  useEffect(() => stop, [stop]);
  return listeners;
}

function selectRange(user: () => RangeUser): { readonly listeners: RangeListeners; readonly stop: () => void } {
  let dragging = new AbortController();

  /**
   * The range follows the position of the mouse, not the events of cells: a browser that drags the selected text of a
   * field reports nothing on the way.
   */
  const follow = (table: HTMLTableElement, pointerId: number): void => {
    dragging.abort();
    dragging = new AbortController();
    const { signal } = dragging;
    const move = (event: PointerEvent): void => {
      if (event.pointerId !== pointerId) return;
      const { selection } = user();
      // Without a focused field no key would reach the range.
      const cell = cellOf(document.activeElement) && cellUnder(table, event);
      if (cell && !isSameCell(cell, selection.corner.value)) selection.extendTo(cell);
      if (event.type !== 'pointermove' || (event.buttons & 1) === 0) dragging.abort();
    };
    const cancel = (event: PointerEvent): void => {
      if (event.pointerId === pointerId) dragging.abort();
    };
    document.addEventListener('pointermove', move, { signal });
    // The last move may be where the button is released. A release outside of the window comes here, too.
    document.addEventListener('pointerup', move, { signal });
    document.addEventListener('pointercancel', cancel, { signal });
  };

  const listeners: RangeListeners = {
    onKeyDown: (event) => onTableKey(event, user()),
    onFocusIn: ({ target }) => {
      const { selection, onFocus } = user();
      const cell = cellOf(target);
      onFocus(cell);
      if (!cell) return;
      if (selection.picking.value) {
        // The focus came in another way, as by a long press or from a screen reader.
        selection.extendTo(cell);
        if (target instanceof HTMLElement) target.blur();
      } else if (!isSameCell(cell, selection.active.value)) selection.enter(cell);
    },
    onInput: () => user().selection.collapse(),
    // The tap of a finger comes here, too.
    onMouseDown: (event) => {
      const { selection } = user();
      const cell = cellOf(event.target);
      if (!cell || event.button !== 0) return;
      const isCorner = event.shiftKey || selection.picking.value;
      if (!isCorner || !selection.active.value) return selection.enter(cell);
      event.preventDefault();
      selection.extendTo(cell);
    },
    onPointerDown: (event) => {
      const { target, pointerType, pointerId, button, defaultPrevented } = event;
      if (defaultPrevented || pointerType !== 'mouse' || button !== 0 || user().selection.picking.value) return;
      if (!cellOf(target) || (target instanceof Element && target.closest('button'))) return;
      follow(event.currentTarget, pointerId);
    },
    onDragStart: (event) => event.preventDefault(),
  };
  return { listeners, stop: () => dragging.abort() };
}
