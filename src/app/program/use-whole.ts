import type { RefObject } from 'preact';
import { useEffect } from 'preact/hooks';

/**
 * A second click before or behind the text of a field leaves it selected as the first one did, so that what is typed
 * next replaces it. A click between its digits puts the caret there.
 */
export function useWhole(input: RefObject<HTMLInputElement | null>): void {
  useEffect(() => {
    const { current } = input;
    if (!current) return;
    let wasWhole = false;
    const down = (): void => {
      const { selectionStart, selectionEnd, value } = current;
      wasWhole = document.activeElement === current && selectionStart === 0 && selectionEnd === value.length;
    };
    const settle = (): void => {
      const { selectionStart: caret, selectionEnd, value } = current;
      if (wasWhole && caret === selectionEnd && (caret === 0 || caret === value.length)) current.select();
    };
    // Chromium moves the caret out of a selection only after the event.
    const click = (): void => void setTimeout(settle);
    current.addEventListener('mousedown', down);
    current.addEventListener('click', click);
    return () => {
      current.removeEventListener('mousedown', down);
      current.removeEventListener('click', click);
    };
  }, [input]);
}
