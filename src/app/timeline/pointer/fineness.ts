/** Up to here beside where it took it a pointer moves what it holds as far as itself, in pixels. */
const PLAIN = 48;
/** From here on it moves it as finely as can be. */
const FINEST = 180;
/** Then a step of the value takes at least so many pixels: a finger finds each. */
const STEP = 10;
/** And what is held goes at most this share of the way of the pointer. */
const SLOW = 1 / 4;

/**
 * How finely a pointer moves what it holds: the further away, the finer, so that a finger finds a single step.
 * @param away from where it took it, across the movement, in pixels.
 * @returns 0 for as far as itself, 1 for as finely as can be.
 */
export function finenessAt(away: number): number {
  return Math.min(1, Math.max(0, (Math.abs(away) - PLAIN) / (FINEST - PLAIN)));
}

/**
 * How far a value goes.
 * @param plain how far it would go if it went with the pointer.
 * @param way of the pointer in pixels.
 * @param step of the value.
 */
export function refined(plain: number, way: number, step: number, fineness: number): number {
  if (plain === 0) return 0;
  const finest = Math.min(SLOW, (Math.abs(way) * step) / STEP / Math.abs(plain));
  return plain * finest ** fineness;
}
