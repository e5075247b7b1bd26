/**
 * After a click a browser allows a port chooser for five seconds. An older click is not carried out late. Milliseconds.
 */
const FRESH = 4000;

/**
 * Takes clicks on the first picture of the page, which cannot act yet. The last clicked button shows that it was
 * clicked.
 * @returns a function that carries out that click, once the page is there.
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
    // The page may have replaced it in the meantime.
    if (!last?.button.isConnected) return;
    last.button.removeAttribute('aria-disabled');
    if (performance.now() - last.at < FRESH) last.button.click();
  };
}
