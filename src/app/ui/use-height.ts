import type { RefObject } from 'preact';
import { useLayoutEffect } from 'preact/hooks';

/**
 * Gives the styles the height of something that stays at an edge, so that nothing scrolls behind it.
 * @param name null: the styles do not need it. Setting it restyles the whole page.
 * @param likely the height that it mostly has. It is set before the first drawing, which is then not done twice.
 */
export function useHeight(element: RefObject<HTMLElement | null>, name: `--${string}` | null, likely?: number): void {
  useLayoutEffect(() => {
    const { current } = element;
    if (!current || !name) return;
    const { style } = document.documentElement;
    let told = likely;
    if (likely !== undefined) style.setProperty(name, `${likely}px`);
    // The observer brings the height. Asking the element would lay out the page once more.
    const observer = new ResizeObserver((entries) => {
      const height = Math.ceil(entries.at(-1)?.borderBoxSize[0]?.blockSize ?? current.offsetHeight);
      if (height === told) return;
      told = height;
      style.setProperty(name, `${height}px`);
    });
    observer.observe(current);
    return () => {
      observer.disconnect();
      style.removeProperty(name);
    };
  }, [element, name, likely]);
}
