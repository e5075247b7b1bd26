/** Made once for each way of writing: a formatter is dear, and a list has thousands of days. */
const formatters = new Map<string, Intl.DateTimeFormat>();

/** How a time is written in a language, by the clock of where the device is now. */
export function dateFormat(locale: string, options: Intl.DateTimeFormatOptions): Intl.DateTimeFormat {
  // One keeps the zone in which it was made, and a device may travel.
  const key = [locale, new Date().getTimezoneOffset(), JSON.stringify(options)].join();
  const made = formatters.get(key) ?? new Intl.DateTimeFormat(locale, options);
  formatters.set(key, made);
  return made;
}
