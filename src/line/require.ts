/** @throws RangeError unless it is a number of at least `least`: NaN would stop the clock, and nothing would say so. */
export function requireNumber(value: number, name: string, least = Number.NEGATIVE_INFINITY): void {
  if (typeof value !== 'number' || !(value >= least)) {
    throw new RangeError(`${name} must be a number${Number.isFinite(least) ? ` of at least ${least}` : ''}.`);
  }
}
