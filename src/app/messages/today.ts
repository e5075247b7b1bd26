import { signal } from '@preact/signals';
import { on } from '../browser/lifecycle.js';

/** How often the page looks at the calendar, in milliseconds. */
const LOOK = 60_000;

/** The day and the time zone for which the texts on the screen were made. */
const calendar = signal(now());

function now(): string {
  const date = new Date();
  return `${date.toDateString()} ${date.getTimezoneOffset()}`;
}

/** Where a component asks, it asks again when the day or the time zone of the device has changed. */
export function askCalendar(): void {
  calendar.value;
}

/** Whether it is a time of this day. Where a component asks, it asks again as for {@link askCalendar}. */
export function isToday(time: Date): boolean {
  askCalendar();
  // Not from the signal: a page that has just come out of sleep has not looked at the calendar yet.
  return time.toDateString() === new Date().toDateString();
}

/**
 * From now on the texts follow the calendar. A page may stay open overnight, also on a computer that sleeps: then
 * “verified 14:32” would seem to be of today. A computer may travel, too: two times on the screen must not be of two
 * zones.
 * @returns a function that ends this.
 */
export function followDay(): () => void {
  const look = (): void => {
    calendar.value = now();
  };
  look();
  const looking = setInterval(look, LOOK);
  const end = on('return', look);
  return () => {
    clearInterval(looking);
    end();
  };
}
