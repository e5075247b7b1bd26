import type { RefObject } from 'preact';
import { useEffect, useRef } from 'preact/hooks';
import type { OnStep } from './field-tools.js';

/** How far a finger moves for one step, in pixels. */
const TRAVEL = 14;

/** A finger on the field: it may become a swipe, or scroll the page. */
interface Swipe {
  readonly id: number;
  /** Where the last step was; at first where the finger came down. */
  x: number;
  readonly y: number;
  /** The selected part of the text, to select it again; null when all of it was selected. */
  readonly marked: readonly [start: number, end: number] | null;
  /** Whether it has made a step. From then on its direction does not matter. */
  going: boolean;
}

/**
 * A finger or pen that moves sideways over the focused field steps it; to the right is up. Any other direction, and any
 * other field, scrolls the page. A mouse selects the text.
 */
export function useSwipe(input: RefObject<HTMLInputElement | null>, onStep: OnStep): void {
  const latest = useRef(onStep);
  latest.current = onStep;
  useEffect(() => {
    const { current } = input;
    if (!current) return;
    let swipe: Swipe | null = null;
    const down = (event: PointerEvent): void => {
      const { pointerId: id, clientX: x, clientY: y } = event;
      const takes = event.isPrimary && event.pointerType !== 'mouse' && document.activeElement === current;
      forget();
      if (!takes) return;
      swipe = { id, x, y, marked: markedIn(current), going: false };
      addEventListener('pointermove', move);
      addEventListener('pointerup', end);
      addEventListener('pointercancel', end);
    };
    const move = ({ pointerId, clientX, clientY, buttons }: PointerEvent): void => {
      if (pointerId !== swipe?.id) return;
      // A pen was lifted where the page could not hear it, and moves above the screen.
      if ((buttons & 1) === 0) {
        forget();
        return;
      }
      const way = clientX - swipe.x;
      const across = Math.abs(clientY - swipe.y);
      if (!swipe.going && across >= TRAVEL && across >= Math.abs(way)) {
        forget();
        return;
      }
      const steps = Math.trunc(way / TRAVEL);
      if (steps === 0) return;
      swipe.x += steps * TRAVEL;
      swipe.going = true;
      for (let step = 0; step < Math.abs(steps); step++) latest.current(steps > 0 ? 1 : -1);
    };
    const end = ({ pointerId }: PointerEvent): void => {
      if (pointerId !== swipe?.id) return;
      // A new value has moved the caret, and a pen selects what it passes over.
      if (swipe.going) current.setSelectionRange(...(swipe.marked ?? ([0, current.value.length] as const)));
      forget();
    };
    const forget = (): void => {
      swipe = null;
      removeEventListener('pointermove', move);
      removeEventListener('pointerup', end);
      removeEventListener('pointercancel', end);
    };
    current.addEventListener('pointerdown', down);
    return () => {
      current.removeEventListener('pointerdown', down);
      forget();
    };
  }, [input]);
}

function markedIn({ selectionStart, selectionEnd, value }: HTMLInputElement): Swipe['marked'] {
  const start = selectionStart ?? 0;
  const end = selectionEnd ?? 0;
  return start === 0 && end === value.length ? null : [start, end];
}
