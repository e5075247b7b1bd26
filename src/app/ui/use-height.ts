import type { RefObject } from 'preact';
import { useLayoutEffect } from 'preact/hooks';

/**
 * Tells the styles under this name how high something is that stays at an edge, so that nothing is scrolled to behind
 * it.
 * @param usual what the styles take it for where they are not told: telling them styles the whole page anew.
 */
export function useHeight(element: RefObject<HTMLElement | null>, name: `--${string}`, usual?: number): void {
  useLayoutEffect(() => {
    const { current } = element;
    if (!current) return;
    const { style } = document.documentElement;
    // What it tells is known: to ask the element would style and lay out the page between two of these.
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
