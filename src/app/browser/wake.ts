/** Seconds between two looks at the clock. */
const LOOK = 5;
/** After a gap of this many seconds between two looks, the computer must have slept. */
const SLEPT = 30;

/**
 * Calls back when the computer wakes from sleep, or the browser continues a page that it had frozen. In the background
 * a page runs less often anyway, so there a gap means nothing.
 */
export function onWake(callback: () => void): void {
  let last = Date.now();
  let visible = document.visibilityState === 'visible';
  setInterval(() => {
    const now = Date.now();
    if (visible && now - last > SLEPT * 1000) callback();
    last = now;
    visible = document.visibilityState === 'visible';
  }, LOOK * 1000);
  document.addEventListener('visibilitychange', () => {
    visible = false;
  });
  document.addEventListener('resume', callback);
}
