// How much of a long matrix is tried: `npm run test:matrix` tries all of it, every other run another eighth. With CI
// set it is the same eighth each time, so that no change is refused by chance; CI runs the whole matrix as well.

import { env } from 'node:process';

const EIGHTHS = 8;
const { CI } = env;
const first = CI ? 0 : Math.floor(Math.random() * EIGHTHS);

/** Whether this run tries all cases. */
const isWhole = import.meta.env.MODE === 'matrix';

/** The cases that this run tries. */
export function shareOf<T>(cases: readonly T[]): readonly T[] {
  return isWhole ? cases : cases.filter((_, index) => index % EIGHTHS === first);
}

/** How often this run tries a property. */
export function runsOf(whole: number): number {
  return isWhole ? whole : Math.ceil(whole / EIGHTHS);
}
