import type { RefObject } from 'preact';
import { useLayoutEffect } from 'preact/hooks';

/** What else may lie there when one of them goes. */
const SHEETS = '.edit-sheet, .row-panel:popover-open';

/** Lays a sheet above everything, makes room for it, and keeps the edited field in sight. */
export function useSheetPlace(sheet: RefObject<HTMLElement | null>, input: HTMLInputElement): void {
  useLayoutEffect(() => (sheet.current ? lift(sheet.current) : undefined), [sheet]);
  useLayoutEffect(
    () => (sheet.current ? makeRoom(sheet.current, input.closest('tr') ?? input, 'nearest') : undefined),
    [sheet, input],
  );
}

/** The same for the tools of a row: as much as possible of the rows from this one on stays in sight. */
export function raise(sheet: HTMLElement, row: Element): () => void {
  sheet.popover = 'manual';
  sheet.classList.add('low-sheet');
  const lower = lift(sheet);
  const leave = makeRoom(sheet, row, 'start');
  return () => {
    leave();
    lower();
  };
}

function lift(sheet: HTMLElement): () => void {
  const { documentElement } = document;
  // Also above a dialog. Where a browser has no popover, the styles do what they can.
  sheet.showPopover?.();
  documentElement.setAttribute('data-sheet', '');
  return () => {
    // A tap has put the sheet away. It must end where it began, so nothing moves under it yet.
    requestAnimationFrame(() => {
      if (document.querySelector(SHEETS)) return;
      documentElement.removeAttribute('data-sheet');
      documentElement.style.removeProperty('--sheet');
    });
  };
}

function makeRoom(sheet: HTMLElement, around: Element, block: ScrollLogicalPosition): () => void {
  const place = (): void => {
    // A field beside the sheet is not covered. The sheet may still be sliding up, so its present position does not
    // count, only its height.
    const covers = around.getBoundingClientRect().right > sheet.getBoundingClientRect().left;
    document.documentElement.style.setProperty('--sheet', `${covers ? sheet.offsetHeight : 0}px`);
    around.scrollIntoView({ block: covers ? block : 'nearest' });
  };
  const observer = new ResizeObserver(place);
  observer.observe(sheet);
  addEventListener('resize', place);
  place();
  return () => {
    observer.disconnect();
    removeEventListener('resize', place);
  };
}
