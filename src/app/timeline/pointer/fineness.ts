/** Up to this distance from where it took the handle, the pointer moves the value as far as itself. In pixels. */
const PLAIN = 48;
/** From this distance on, it moves the value as finely as possible. In pixels. */
const FINEST = 180;
/** There, one step of the value takes at least this many pixels, so that a finger finds each. */
const STEP = 10;
/** And the handle goes at most this share of the pointer's way. */
const SLOW = 1 / 4;

/**
 * How finely a pointer moves a value: the further away it is, the finer, so that a finger finds a single step.
 * @param away the distance from where it took the handle, across the movement, in pixels.
 * @returns 0 for as far as the pointer, 1 for as finely as possible.
 */
export function finenessAt(away: number): number {
  return Math.min(1, Math.max(0, (Math.abs(away) - PLAIN) / (FINEST - PLAIN)));
}

/**
 * How far a value moves.
 * @param plain how far it would move with the pointer.
 * @param way the way of the pointer in pixels.
 * @param step of the value.
 */
export function refined(plain: number, way: number, step: number, fineness: number): number {
  if (plain === 0) return 0;
  const finest = Math.min(SLOW, (Math.abs(way) * step) / STEP / Math.abs(plain));
  return plain * finest ** fineness;
}
