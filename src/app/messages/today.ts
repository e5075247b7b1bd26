import { signal } from '@preact/signals';

/** How often the page looks at the calendar, in milliseconds. */
const LOOK = 60_000;

/** The day on which the texts on the screen were made. */
const today = signal(new Date().toDateString());

/** Whether it is a time of this day. Where a component asks, it asks again when the day has changed. */
export function isToday(time: Date): boolean {
  const now = new Date().toDateString();
  // Asked for each time: a page that has just come out of sleep has not looked at the calendar yet.
  return today.value !== '' && time.toDateString() === now;
}

/**
 * From now on the texts follow the calendar. A page may stay open overnight, also on a computer that sleeps: then
 * “verified 14:32” would seem to be of today.
 * @returns a function that ends this.
 */
export function followDay(): () => void {
  const look = (): void => {
    today.value = new Date().toDateString();
  };
  look();
  const looking = setInterval(look, LOOK);
  document.addEventListener('visibilitychange', look);
  return () => {
    clearInterval(looking);
    document.removeEventListener('visibilitychange', look);
  };
}
