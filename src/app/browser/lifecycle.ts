/** Seconds between two looks at the clock. */
const LOOK = 5;
/** After a gap of this many seconds between two looks, the computer must have slept. */
const SLEPT = 30;

/**
 * What happens to the page as a whole.
 * - `leave`: the pilot leaves it. No question to the browser may be answered any more.
 * - `hide`: it is left, or no longer seen. A phone may end it in the background without any warning.
 * - `away`: as `hide`, or another window has come before it, which hears the keys from now on.
 * - `return`: it is seen again, or has the focus or the network again.
 * - `restore`: it is shown again, as it was when it was left.
 * - `wake`: the computer has slept, or the browser had frozen the page.
 */
export type Moment = 'leave' | 'hide' | 'away' | 'return' | 'restore' | 'wake';

/**
 * Calls back at each such moment.
 * @returns a function that ends this.
 */
export function on(moment: Moment, act: () => void): () => void {
  const over = new AbortController();
  const hear = (on: EventTarget, type: string, when: (event: Event) => boolean = () => true): void =>
    on.addEventListener(type, (event) => when(event) && act(), over);
  const hears: Readonly<Record<Moment, () => void>> = {
    leave: () => hear(window, 'pagehide'),
    hide: () => {
      hears.leave();
      hear(document, 'visibilitychange', () => document.hidden);
    },
    away: () => {
      hears.hide();
      hear(window, 'blur');
    },
    return: () => {
      hear(document, 'visibilitychange', () => !document.hidden);
      hear(window, 'focus');
      hear(window, 'online');
    },
    restore: () => hear(window, 'pageshow', (event) => (event as PageTransitionEvent).persisted),
    wake: () => {
      hear(document, 'resume');
      hearGaps(act, over.signal);
    },
  };
  hears[moment]();
  return () => over.abort();
}

/** In the background a page runs less often anyway, so there a gap between two looks at the clock means nothing. */
function hearGaps(act: () => void, signal: AbortSignal): void {
  let last = Date.now();
  let visible = !document.hidden;
  const looking = setInterval(() => {
    const now = Date.now();
    if (visible && now - last > SLEPT * 1000) act();
    last = now;
    visible = !document.hidden;
  }, LOOK * 1000);
  document.addEventListener('visibilitychange', () => (visible = false), { signal });
  signal.addEventListener('abort', () => clearInterval(looking));
}

const warn = (event: Event): void => event.preventDefault();

/** From now on the browser asks the pilot before the page is left, or does so no longer. */
export function askBeforeLeaving(isOn: boolean): void {
  if (isOn) addEventListener('beforeunload', warn);
  else removeEventListener('beforeunload', warn);
}
