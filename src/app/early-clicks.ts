/**
 * A browser lets a click ask for a port for five seconds: one that is older than this, in milliseconds, is not done
 * late.
 */
const FRESH = 4000;

/**
 * Takes the clicks on a picture of the page that cannot do anything yet. The button that was clicked last shows it.
 * @returns a function that does that click, now that the page is there.
 */
export function earlyClicks(root: HTMLElement): () => void {
  let last: { readonly button: HTMLElement; readonly at: number } | null = null;
  const note = (event: MouseEvent): void => {
    const button = event.target instanceof Element ? event.target.closest('button') : null;
    if (!button) return;
    last?.button.removeAttribute('aria-disabled');
    button.setAttribute('aria-disabled', 'true');
    last = { button, at: event.timeStamp };
  };
  root.addEventListener('click', note);
  return () => {
    root.removeEventListener('click', note);
    // The page may have put something else in its place meanwhile.
    if (!last?.button.isConnected) return;
    last.button.removeAttribute('aria-disabled');
    if (performance.now() - last.at < FRESH) last.button.click();
  };
}
