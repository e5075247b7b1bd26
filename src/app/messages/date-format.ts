/** One formatter for each form: making one is slow, and a list has thousands of days. */
const formatters = new Map<string, Intl.DateTimeFormat>();

/** Formats a time in a language, by the present time zone of the device. */
export function dateFormat(locale: string, options: Intl.DateTimeFormatOptions): Intl.DateTimeFormat {
  // A formatter keeps the time zone in which it was made, and a device may travel.
  const key = [locale, new Date().getTimezoneOffset(), JSON.stringify(options)].join();
  const made = formatters.get(key) ?? new Intl.DateTimeFormat(locale, options);
  formatters.set(key, made);
  return made;
}
