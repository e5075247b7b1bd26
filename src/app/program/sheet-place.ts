import type { RefObject } from 'preact';
import { useLayoutEffect } from 'preact/hooks';

/** What stays in sight while a field is edited: its row, or its group. */
const AROUND = 'tr, .figure';

/** Lays a sheet above everything, makes room for it, and keeps the edited field in sight. */
export function useSheetPlace(sheet: RefObject<HTMLElement | null>, input: HTMLInputElement): void {
  useLayoutEffect(() => {
    const { documentElement } = document;
    // Also above a dialog. Where a browser has no popover, the styles do what they can.
    sheet.current?.showPopover?.();
    documentElement.setAttribute('data-sheet', '');
    return () => {
      // A tap has put the sheet away. It must end where it began, so nothing moves under it yet.
      requestAnimationFrame(() => {
        if (document.querySelector('.edit-sheet')) return;
        documentElement.removeAttribute('data-sheet');
        documentElement.style.removeProperty('--sheet');
      });
    };
  }, [sheet]);
  useLayoutEffect(() => {
    const { current } = sheet;
    if (!current) return;
    const around = input.closest(AROUND) ?? input;
    const place = (): void => {
      // A field beside the sheet is not covered. The sheet may still be sliding up, so its present position does not
      // count, only its height.
      const covers = around.getBoundingClientRect().right > current.getBoundingClientRect().left;
      document.documentElement.style.setProperty('--sheet', `${covers ? current.offsetHeight : 0}px`);
      around.scrollIntoView({ block: 'nearest' });
    };
    const observer = new ResizeObserver(place);
    observer.observe(current);
    addEventListener('resize', place);
    place();
    return () => {
      observer.disconnect();
      removeEventListener('resize', place);
    };
  }, [sheet, input]);
}
