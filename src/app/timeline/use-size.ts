import { useSignal } from '@preact/signals';
import type { RefObject } from 'preact';
import { useLayoutEffect } from 'preact/hooks';

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** The size before anything has been measured, in pixels. */
const USUAL: Size = { width: 640, height: 320 };

/** The size of an element in pixels. Changes come one frame late. */
export function useSize(element: RefObject<HTMLElement | null>): Size {
  const size = useSignal(USUAL);
  useLayoutEffect(() => {
    const { current } = element;
    if (!current) return;
    const measure = (): void => {
      const { clientWidth: width, clientHeight: height } = current;
      const before = size.peek();
      if (width > 0 && (width !== before.width || height !== before.height)) size.value = { width, height };
    };
    measure();
    let frame = 0;
    // A note in the table may change the room: what was typed is drawn first, and the rest a frame later.
    const observer = new ResizeObserver(() => {
      cancelAnimationFrame(frame);
      frame = requestAnimationFrame(measure);
    });
    observer.observe(current);
    return () => {
      observer.disconnect();
      cancelAnimationFrame(frame);
    };
  }, []);
  return size.value;
}
