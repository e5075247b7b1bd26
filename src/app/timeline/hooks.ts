import { effect, type ReadonlySignal, useSignal } from '@preact/signals';
import type { RefObject } from 'preact';
import { useEffect, useLayoutEffect, useMemo, useRef } from 'preact/hooks';

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Before anything has been measured, in pixels. */
const USUAL: Size = { width: 640, height: 320 };

/** The size of an element in pixels, as it is and, a frame late, as it changes. */
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
    // A note in the table may take some of the room: what was typed is seen before all is drawn for the rest of it.
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

/** A function that stays the same while what it calls may change at each drawing. */
export function useStable<F extends ((...args: never[]) => unknown) | undefined>(called: F): F {
  const latest = useRef(called);
  latest.current = called;
  const stable = useMemo(() => ((...args: never[]) => latest.current?.(...args)) as F, []);
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

/**
 * Changes that follow each other faster than this are drawn as they come: who types is not kept waiting. Milliseconds.
 */
const HURRY = 500;

/**
 * Whether what is drawn now goes gently from where it was, so that the eye can follow: the styles do it. Not while a
 * handle is in hand, nor when what is in view or the room for it has changed, nor while one change follows the other.
 * @param drawn all that is drawn; another object whenever it changes.
 * @param frame what lets everything jump when it changes.
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
