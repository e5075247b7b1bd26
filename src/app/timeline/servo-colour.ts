const COLOURS = 6;

/** The style that gives everything of a servo its colour, `--servo`; null for nothing of a servo. */
export function servoColour(servo: number | null): Record<string, string> {
  return servo === null ? {} : { '--servo': `var(--servo-${(servo % COLOURS) + 1})` };
}
