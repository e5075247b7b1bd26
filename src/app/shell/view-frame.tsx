import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { useQuery } from '../ui/use-query.js';
import { placeIn, putBackPlace, type ViewPlace } from './place.js';
import type { View, Views } from './views.js';

interface ViewFrameProps {
  readonly views: Views;
  /** Whether bytes move, so that the content is about to change. */
  readonly busy: boolean;
  /** Whether it takes the whole room, to its edges. */
  readonly whole: boolean;
  readonly children: ComponentChildren;
}

/**
 * The frame around the view. A pilot who comes back to a view finds it scrolled as before,
 * with the focus in the same place.
 */
export function ViewFrame({ views, busy, whole, children }: ViewFrameProps) {
  const main = useRef<HTMLElement>(null);
  const places = useRef(new Map<View, ViewPlace>());
  const before = useRef<View | null>(null);
  const inHand = useRef<Element | null>(null);
  const byTouch = useQuery('(pointer: coarse)');
  const shown = views.shown.value;
  useLayoutEffect(
    () =>
      views.onLeave((view) => {
        if (main.current) places.current.set(view, placeIn(main.current, inHand.current));
      }),
    [views],
  );
  useLayoutEffect(() => {
    // At the start there is nothing to put back; the browser decides.
    if (before.current !== null && main.current) putBackPlace(main.current, places.current.get(shown), byTouch.peek());
    before.current = shown;
  }, [shown, byTouch]);
  return (
    <main
      ref={main}
      class={`view ${shown}-view ${whole ? 'whole' : ''}`}
      tabIndex={-1}
      aria-busy={busy}
      onFocusCapture={({ target }) => {
        if (target instanceof Element) inHand.current = target;
      }}
    >
      {children}
    </main>
  );
}
