import { useSignal } from '@preact/signals';
import type { RefObject } from 'preact';
import { useLayoutEffect, useMemo, useRef } from 'preact/hooks';

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

/** A function that stays the same, and calls the latest version of another one. */
export function useStable<F extends ((...args: never[]) => unknown) | undefined>(called: F): F {
  const latest = useRef(called);
  latest.current = called;
  const stable = useMemo(() => ((...args: never[]) => latest.current?.(...args)) as F, []);
  return called && stable;
}

/** Changes that follow each other within this time are drawn at once, so that typing never waits. In milliseconds. */
const HURRY = 500;

/**
 * Whether the present drawing moves gently from the one before (the styles do it), so that the eye can follow. Not
 * while a handle is held, not after a change of view or size, and not when changes follow each other quickly.
 * @param drawn everything that is drawn; another object after each change.
 * @param frame the things whose change makes everything jump.
 */
export function useGlides(drawn: unknown, frame: readonly unknown[], held: boolean): boolean {
  const before = useRef({ drawn, frame, at: Number.NEGATIVE_INFINITY, glides: false });
  const last = before.current;
  if (held) {
    before.current = { drawn, frame, at: Number.NEGATIVE_INFINITY, glides: false };
  } else if (drawn !== last.drawn) {
    const now = performance.now();
    const glides = now - last.at >= HURRY && frame.every((part, i) => part === last.frame[i]);
    before.current = { drawn, frame, at: now, glides };
  }
  return before.current.glides;
}
