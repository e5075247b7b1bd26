import { effect, type ReadonlySignal, useSignal } from '@preact/signals';
import { useEffect, useMemo } from 'preact/hooks';

/** During a drag every frame brings a change. The late part then waits this long at most, in milliseconds. */
const LATEST = 500;

/**
 * The value of a signal in the frame after the next one, or later while each frame brings a new one: so that what was
 * typed or dragged is drawn before a large part that follows from it.
 * @returns its value, and a function that catches up at once.
 */
export function useLate<T>(source: ReadonlySignal<T>): [value: T, catchUp: () => void] {
  const late = useSignal(source.peek());
  const { changed, catchUp, drop } = useMemo(() => {
    let frame = 0;
    let since = 0;
    let goesOn = false;
    const drop = (): void => {
      cancelAnimationFrame(frame);
      frame = 0;
    };
    const catchUp = (): void => {
      drop();
      late.value = source.peek();
    };
    const atFrame = (): void => {
      if (goesOn && performance.now() - since < LATEST) frame = requestAnimationFrame(atFrame);
      else catchUp();
      goesOn = false;
    };
    const changed = (): void => {
      goesOn = true;
      if (frame !== 0) return;
      since = performance.now();
      frame = requestAnimationFrame(atFrame);
    };
    return { changed, catchUp, drop };
  }, [source]);
  useEffect(() => {
    const stop = effect(() => void (source.value !== late.peek() && changed()));
    return () => {
      stop();
      drop();
    };
  }, [source]);
  return [late.value, catchUp];
}
