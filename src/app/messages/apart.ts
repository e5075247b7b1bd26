/** Hebrew, Arabic, and other scripts that are written from right to left. */
const LEFTWARDS = /[\u0590-\u08ff\ufb1d-\ufdff\ufe70-\ufefc\u{10800}-\u{10fff}\u{1e800}-\u{1efff}]/u;

/**
 * A text of the pilot inside a sentence, such as the name of a model. One that is written from right to left would take
 * the figure after it to its other side; the two characters around it prevent that.
 */
export function apart(text: string): string {
  return LEFTWARDS.test(text) ? `\u2068${text}\u2069` : text;
}
