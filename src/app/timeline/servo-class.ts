import './servo-class.css';

const COLOURS = 6;

/** The class that gives what belongs to a servo its colour, `--servo`: the same everywhere. */
export function servoClass(servo: number): string {
  return `colour-${servo % COLOURS}`;
}
