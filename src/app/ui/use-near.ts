import type { RefObject } from 'preact';
import { useEffect } from 'preact/hooks';

/**
 * Acts when something comes near the window, such as the end of a long list.
 * @param act must stay the same function while it means the same.
 * @param margin how near, in pixels.
 */
export function useNear(place: RefObject<HTMLElement | null>, act: () => void, margin: number): void {
  useEffect(() => {
    const observer = new IntersectionObserver((seen) => seen.some((each) => each.isIntersecting) && act(), {
      rootMargin: `${margin}px`,
    });
    if (place.current) observer.observe(place.current);
    return () => observer.disconnect();
  }, [place, act, margin]);
}
