import type { TargetedFocusEvent, TargetedPointerEvent } from 'preact';
import { cellOf, cellUnder, isSameCell } from './table-cells.js';
import type { TableModel } from './table-model.js';

/**
 * The listeners of a table for mouse, finger and focus. Cells are selected as in a spreadsheet: from the pressed cell
 * to the one under the mouse, or to the next one with Shift or after “Select range”. A finger scrolls, so it selects
 * with two taps.
 */
export function pointerListeners(table: TableModel) {
  const { selection } = table;
  let dragging = new AbortController();
  /** Whether the pressed field was selected as a whole. */
  let wasWhole = false;

  /**
   * The range follows the position of the mouse, not the events of cells: a browser that drags the selected text of a
   * field reports nothing on the way.
   */
  const follow = (element: HTMLTableElement, pointerId: number): void => {
    dragging.abort();
    dragging = new AbortController();
    const { signal } = dragging;
    const move = (event: PointerEvent): void => {
      if (event.pointerId !== pointerId) return;
      // Without a focused field no key would reach the range.
      const cell = cellOf(document.activeElement) && cellUnder(element, event);
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

  return {
    onFocusIn: ({ target }: FocusEvent): void => {
      const cell = cellOf(target);
      table.entered(cell);
      if (!cell) return;
      if (selection.picking.value) {
        // The focus came in another way, as by a long press or from a screen reader.
        selection.extendTo(cell);
        if (target instanceof HTMLElement) target.blur();
      } else if (!isSameCell(cell, selection.active.value)) selection.enter(cell);
    },
    onFocusOut: ({ target, relatedTarget, currentTarget }: TargetedFocusEvent<HTMLTableElement>): void => {
      const stays = relatedTarget instanceof Node && currentTarget.contains(relatedTarget);
      // A window that was left comes back with its focus.
      if (!stays && target !== document.activeElement) table.left();
    },
    onInput: (): void => selection.collapse(),
    // The tap of a finger comes here, too.
    onMouseDown: (event: MouseEvent): void => {
      const { target } = event;
      wasWhole =
        target instanceof HTMLInputElement &&
        target === document.activeElement &&
        target.selectionStart === 0 &&
        target.selectionEnd === target.value.length;
      const cell = cellOf(target);
      if (!cell || event.button !== 0) return;
      const isCorner = selection.active.value !== null && (event.shiftKey || selection.picking.value);
      if (isCorner) {
        event.preventDefault();
        selection.extendTo(cell);
      } else selection.enter(cell);
    },
    /**
     * A second click before or behind the text of a field leaves it selected as the first one did, so that what is
     * typed next replaces it. A click between its digits puts the caret there.
     */
    onClick: ({ target }: MouseEvent): void => {
      if (!wasWhole || !(target instanceof HTMLInputElement)) return;
      const { value } = target;
      // Chromium moves the caret out of a selection only after the event. A key that was heard before keeps its place.
      setTimeout(() => {
        const { selectionStart: caret, selectionEnd } = target;
        const isAtEnd = caret === selectionEnd && (caret === 0 || caret === value.length);
        if (isAtEnd && target.value === value) target.select();
      });
    },
    onPointerDown: (event: TargetedPointerEvent<HTMLTableElement>): void => {
      const { target, pointerType, pointerId, button, defaultPrevented } = event;
      if (defaultPrevented || pointerType !== 'mouse' || button !== 0 || selection.picking.value) return;
      if (!cellOf(target) || (target instanceof Element && target.closest('button'))) return;
      follow(event.currentTarget, pointerId);
    },
    // A text that is dragged would change a value without a key press; from field to field, two.
    onDragStart: (event: DragEvent): void => event.preventDefault(),
    onDragOver: refuse,
    onDrop: refuse,
  };
}

function refuse(event: DragEvent): void {
  event.preventDefault();
  if (event.dataTransfer) event.dataTransfer.dropEffect = 'none';
}
