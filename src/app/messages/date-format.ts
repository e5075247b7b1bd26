import { language } from './language.js';
import { askCalendar } from './today.js';

/** The page writes British English. */
const LOCALES: Readonly<Record<string, string>> = { en: 'en-GB' };

/** One formatter for each form: making one is slow, and a list has thousands of days. */
const formatters = new Map<string, Intl.DateTimeFormat>();

/**
 * A time in words, by the present time zone of the device: “23 Nov 2026, 10:08”. It breaks only after a comma: half a
 * date at the end of a line reads as another one.
 */
export function formatDate(options: Intl.DateTimeFormatOptions, time: number): string {
  askCalendar();
  // A formatter keeps the time zone in which it was made, and a device may travel.
  const key = [language.value, new Date().getTimezoneOffset(), JSON.stringify(options)].join();
  const made = formatters.get(key) ?? new Intl.DateTimeFormat(LOCALES[language.value] ?? language.value, options);
  formatters.set(key, made);
  return made.format(time).replace(/(?<!,) /g, '\u00a0');
}
