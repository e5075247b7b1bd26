import { effect, type ReadonlySignal, useSignal } from '@preact/signals';
import type { RefObject } from 'preact';
import { useEffect, useLayoutEffect, useMemo, useRef } from 'preact/hooks';
import { media } from '../browser/doors.js';
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
  return media('(prefers-reduced-motion: reduce)')?.matches ?? false;
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

/**
 * A signal, a frame late: what is drawn more easily, as the field that was typed into, is seen before.
 * @returns its value, and what makes up for the frame.
 */
export function useLate<T>(source: ReadonlySignal<T>): [value: T, catchUp: () => void] {
  const late = useSignal(source.peek());
  const catchUp = useMemo(
    () => (): void => {
      late.value = source.peek();
    },
    [source],
  );
  useEffect(() => {
    let frame = 0;
    const stop = effect(() => {
      void source.value;
      cancelAnimationFrame(frame);
      // The next frame is the one in which the other is drawn.
      frame = requestAnimationFrame(() => {
        frame = requestAnimationFrame(catchUp);
      });
    });
    return () => {
      stop();
      cancelAnimationFrame(frame);
    };
  }, [source]);
  return [late.value, catchUp];
}

const GLIDE = 180;
/**
 * Changes that follow each other faster than this are drawn as they come: who types is not kept waiting. Milliseconds.
 */
const HURRY = 500;

/**
 * The axis to be drawn: `held` while there is one, else `wanted`. From the one to the other it glides, so that the eye
 * can follow; but not when it is the room for it that has changed, nor while one change follows the other.
 */
export function useGlide(wanted: Scale, held: Scale | null, room: number): Scale {
  const shown = useRef(wanted);
  const before = useRef(room);
  const way = useRef<{ from: Scale; to: Scale; start: number } | null>(null);
  const changed = useRef(Number.NEGATIVE_INFINITY);
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
  const now = performance.now();
  const jumps = before.current !== room || now - changed.current < HURRY || prefersStillness();
  before.current = room;
  if (!sameScale(way.current?.to ?? shown.current, wanted)) {
    way.current = jumps ? null : { from: shown.current, to: wanted, start: now };
    changed.current = now;
  }
  if (!way.current) {
    shown.current = wanted;
    return wanted;
  }
  const share = Math.min(1, (now - way.current.start) / GLIDE);
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
