import type { RefObject } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import type { StepOptions } from '../editing/edits.js';

export type OnStep = (direction: 1 | -1, options?: StepOptions) => void;

/** How far a wheel turns for one step, in pixels: half a notch of most mice. */
const NOTCH = 50;

/**
 * The wheel with Alt steps the focused field, with Shift ten steps at once. Without Alt, and over any other field, it
 * scrolls the page, so that scrolling never changes a value.
 */
export function useWheel(input: RefObject<HTMLInputElement | null>, onStep: OnStep): void {
  const latest = useRef(onStep);
  latest.current = onStep;
  useEffect(() => {
    const { current } = input;
    let turned = 0;
    const turn = (event: WheelEvent): void => {
      if (!event.altKey || event.ctrlKey || document.activeElement !== current) return;
      event.preventDefault();
      // With Shift, browsers report the wheel as sideways.
      turned += event.deltaY || event.deltaX;
      if (Math.abs(turned) < NOTCH) return;
      latest.current(turned < 0 ? 1 : -1, { tenfold: event.shiftKey });
      turned = 0;
    };
    // Preact would add a passive listener, and the page would scroll, too.
    current?.addEventListener('wheel', turn, { passive: false });
    return () => current?.removeEventListener('wheel', turn);
  }, [input]);
}

/** Alt with an arrow steps a field, with Shift ten steps at once. @returns whether this key did. */
export function stepByKey(event: KeyboardEvent, onStep: OnStep): boolean {
  const direction = event.key === 'ArrowUp' ? 1 : event.key === 'ArrowDown' ? -1 : 0;
  if (direction === 0 || !event.altKey || event.ctrlKey || event.metaKey) return false;
  event.preventDefault();
  onStep(direction, { tenfold: event.shiftKey });
  return true;
}
