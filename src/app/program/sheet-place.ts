import type { RefObject } from 'preact';
import { useLayoutEffect } from 'preact/hooks';

/** What stays in sight while a field is edited: its row, or what stands with it. */
const AROUND = 'tr, .figure';

/** Lays a sheet above all, makes room for it, and keeps in sight what is edited: nothing covers it. */
export function useSheetPlace(sheet: RefObject<HTMLElement | null>, input: HTMLInputElement): void {
  useLayoutEffect(() => {
    const { documentElement } = document;
    // Also above a dialog; where a browser cannot, the styles have to do.
    sheet.current?.showPopover?.();
    documentElement.setAttribute('data-sheet', '');
    return () => {
      // What has put it away is a tap, which ends where it began: nothing moves under it.
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
      // What lies beside it is not in its way. It may still be on its way up: how high it is tells no place of it.
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
