import { sameLayout } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';

/** Whether a program means the same on two timers: they have the same class and layout. */
export function isOfOneShape(a: Identity, b: Identity): boolean {
  return a.timerClass === b.timerClass && sameLayout(a, b);
}
