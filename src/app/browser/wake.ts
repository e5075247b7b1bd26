/** Seconds between two looks at the clock. */
const LOOK = 5;
/** A gap of so many seconds between two looks means that the computer has slept. */
const SLEPT = 30;

/**
 * Calls back when the computer wakes from sleep, or the browser lets the page go on after it has frozen it. A page in
 * the background is called less often without any sleep: there the gap means nothing.
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
