import { useSignal } from '@preact/signals';
import type { RefObject } from 'preact';
import { useLayoutEffect, useMemo, useRef } from 'preact/hooks';
import { between, type Scale, sameScale } from './scale.js';

/** Before anything has been measured. */
const USUAL_WIDTH = 640;

/** The width of an element in pixels, as it is and as it changes. */
export function useWidth(element: RefObject<HTMLElement | null>): number {
  const width = useSignal(USUAL_WIDTH);
  useLayoutEffect(() => {
    const { current } = element;
    if (!current) return;
    const measure = (): void => {
      if (current.clientWidth > 0) width.value = current.clientWidth;
    };
    measure();
    const observer = new ResizeObserver(measure);
    observer.observe(current);
    return () => observer.disconnect();
  }, []);
  return width.value;
}

/** Whether this person does not want things to move by themselves. */
export function prefersStillness(): boolean {
  return matchMedia('(prefers-reduced-motion: reduce)').matches;
}

/** A function that stays the same while what it calls may change at each drawing. */
export function useStable<A extends unknown[]>(
  called: ((...args: A) => void) | undefined,
): ((...args: A) => void) | undefined {
  const latest = useRef(called);
  latest.current = called;
  const stable = useMemo(
    () =>
      (...args: A): void =>
        latest.current?.(...args),
    [],
  );
  return called && stable;
}

const GLIDE = 180;

/**
 * The axis to be drawn: `held` while there is one, else `wanted`. From the one to the other it glides, so that the eye can follow;
 * but not when it is the room for it that has changed.
 */
export function useGlide(wanted: Scale, held: Scale | null, room: number): Scale {
  const shown = useRef(wanted);
  const before = useRef(room);
  const way = useRef<{ from: Scale; to: Scale; start: number } | null>(null);
  const frame = useRef(0);
  const drawn = useSignal(0);
  // Read, so that each step of the way is drawn.
  void drawn.value;

  useLayoutEffect(() => () => cancelAnimationFrame(frame.current), []);

  if (held) {
    way.current = null;
    shown.current = held;
    return held;
  }
  const jumps = before.current !== room || prefersStillness();
  before.current = room;
  if (!sameScale(way.current?.to ?? shown.current, wanted)) {
    way.current = jumps ? null : { from: shown.current, to: wanted, start: performance.now() };
  }
  if (!way.current) {
    shown.current = wanted;
    return wanted;
  }
  const share = Math.min(1, (performance.now() - way.current.start) / GLIDE);
  if (share >= 1) {
    way.current = null;
    shown.current = wanted;
  } else {
    shown.current = between(way.current.from, wanted, share * (2 - share));
    cancelAnimationFrame(frame.current);
    frame.current = requestAnimationFrame(() => {
      drawn.value++;
    });
  }
  return shown.current;
}
