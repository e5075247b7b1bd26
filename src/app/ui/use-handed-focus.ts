import type { RefObject } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';

interface Box {
  readonly ref: RefObject<HTMLDivElement | null>;
  readonly onFocusIn: (event: FocusEvent) => void;
}

/**
 * Gives the focus to another control of a box when the one that had it has gone: a browser would leave it nowhere.
 * @param next a selector of the control that gets it. It should do no harm when it is pressed by mistake.
 * @returns what the element of the box needs.
 */
export function useHandedFocus(next: string): Box {
  const ref = useRef<HTMLDivElement>(null);
  const last = useRef<EventTarget | null>(null);
  useLayoutEffect(() => {
    const isGone = last.current instanceof Element && !last.current.isConnected;
    if (!isGone) return;
    last.current = null;
    // Not when the pilot has gone elsewhere.
    if (document.activeElement !== document.body) return;
    // The pilot may have scrolled on in the meantime.
    ref.current?.querySelector<HTMLElement>(next)?.focus({ preventScroll: true });
  });
  const onFocusIn = ({ target }: FocusEvent): void => {
    last.current = target;
  };
  return { ref, onFocusIn };
}
