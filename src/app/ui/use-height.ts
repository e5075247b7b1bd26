import type { RefObject } from 'preact';
import { useLayoutEffect } from 'preact/hooks';

/**
 * Gives the styles the height of something that stays at an edge, so that nothing scrolls behind it.
 * @param usual the height that the styles assume without this. Setting it restyles the whole page.
 */
export function useHeight(element: RefObject<HTMLElement | null>, name: `--${string}`, usual?: number): void {
  useLayoutEffect(() => {
    const { current } = element;
    if (!current) return;
    const { style } = document.documentElement;
    // The observer brings the height. Asking the element would lay out the page once more.
    const observer = new ResizeObserver((entries) => {
      const height = Math.round(entries.at(-1)?.borderBoxSize[0]?.blockSize ?? current.offsetHeight);
      if (height === usual) style.removeProperty(name);
      else style.setProperty(name, `${height}px`);
    });
    observer.observe(current);
    return () => {
      observer.disconnect();
      style.removeProperty(name);
    };
  }, [element, name, usual]);
}
