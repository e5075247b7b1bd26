/** Up to this distance from where it took the handle, the pointer moves the value as far as itself. In pixels. */
const PLAIN = 90;
/** Beyond, one step of the value takes at least this many pixels, so that a finger finds each. */
const STEP = 10;
/** And the handle goes at most this share of the pointer's way. */
const SLOW = 1 / 4;

/** Whether a value moves finely. @param away the distance from where it was taken, across the movement, in pixels. */
export function isFine(away: number): boolean {
  return Math.abs(away) > PLAIN;
}

/**
 * How far a value moves finely.
 * @param plain how far it would move with the pointer.
 * @param way the way of the pointer in pixels.
 * @param step of the value.
 */
export function refined(plain: number, way: number, step: number): number {
  return plain === 0 ? 0 : plain * Math.min(SLOW, (Math.abs(way) * step) / STEP / Math.abs(plain));
}
