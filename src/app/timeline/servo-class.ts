import './servo-class.css';

const COLOURS = 6;

/** The class that gives everything of a servo its colour, `--servo`. */
export function servoClass(servo: number): string {
  return `colour-${servo % COLOURS}`;
}
