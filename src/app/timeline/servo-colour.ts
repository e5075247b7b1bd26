const COLOURS = 6;

/**
 * The attribute that gives everything of a servo its colour, `--servo`; null for nothing of a servo. It is no style:
 * the first picture stands in index.html, where the security policy allows none.
 */
export function servoColour(servo: number | null): { 'data-servo'?: number } {
  return servo === null ? {} : { 'data-servo': servo % COLOURS };
}
