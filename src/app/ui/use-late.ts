import { batch, computed, effect, type ReadonlySignal, useSignal } from '@preact/signals';
import { useEffect, useLayoutEffect, useMemo, useRef } from 'preact/hooks';

/** During a drag every frame brings a change. Late parts then wait this long at most, in milliseconds. */
const LATEST = 500;

/** The late parts that wait. All are drawn in the same frame. */
const waiting = new Set<() => void>();
let frame = 0;
let since = 0;
/** Whether something was asked for since the last frame. */
let goesOn = false;

/** Draws a part in the frame after the next one, or later while each frame asks for something new. */
function drawLate(draw: () => void): void {
  waiting.add(draw);
  goesOn = true;
  if (frame !== 0) return;
  since = performance.now();
  frame = requestAnimationFrame(atFrame);
}

/** Takes a wish back that was given to {@link drawLate}. */
function dropLate(draw: () => void): void {
  waiting.delete(draw);
}

function atFrame(): void {
  if (goesOn && performance.now() - since < LATEST) {
    goesOn = false;
    frame = requestAnimationFrame(atFrame);
    return;
  }
  frame = 0;
  const all = [...waiting];
  waiting.clear();
  batch(() => {
    for (const draw of all) draw();
  });
}

/**
 * The value of a signal, one frame late, so that quicker drawings, such as the field that was typed into, come first.
 * @returns its value, and a function that catches up at once.
 */
export function useLate<T>(source: ReadonlySignal<T>): [value: T, catchUp: () => void] {
  const late = useSignal(source.peek());
  const catchUp = useMemo(
    () => (): void => {
      dropLate(catchUp);
      late.value = source.peek();
    },
    [source],
  );
  useEffect(() => {
    const stop = effect(() => {
      if (source.value !== late.peek()) drawLate(catchUp);
    });
    return () => {
      stop();
      dropLate(catchUp);
    };
  }, [source]);
  return [late.value, catchUp];
}

/**
 * A value that is computed from signals, one frame late.
 * @param of what the value belongs to, such as the program: when that changes, the value follows at once.
 */
export function useLateComputed<T>(compute: () => T, of: ReadonlySignal<unknown>): T {
  const latest = useRef(compute);
  latest.current = compute;
  const source = useMemo(() => {
    let last: { readonly of: unknown; readonly value: T } | null = null;
    return computed(() => {
      const found = { of: of.value, value: latest.current() };
      // The same object for the same value: then nothing is drawn again.
      if (last && last.of === found.of && last.value === found.value) return last;
      last = found;
      return found;
    });
  }, [of]);
  const [late] = useLate(source);
  return (late.of === of.value ? late : source.peek()).value;
}

/**
 * A value that a component is drawn with, one frame late.
 * @param of what the value belongs to, such as the program: when that changes, the value follows at once.
 */
export function useAfter<T>(value: T, of: unknown): T {
  const now = useMemo(() => ({ value, of }), [value, of]);
  const late = useSignal(now);
  const latest = useRef(now);
  latest.current = now;
  const catchUp = useMemo(
    () => (): void => {
      late.value = latest.current;
    },
    [late],
  );
  useLayoutEffect(() => {
    if (late.peek() !== now) drawLate(catchUp);
  }, [now]);
  useEffect(() => () => dropLate(catchUp), []);
  return late.value.of === of ? late.value.value : value;
}
