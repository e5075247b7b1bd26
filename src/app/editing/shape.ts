import { sameLayout } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';

/** Whether a program of the one timer means the same on the other: its class and its layout are the same. */
export function isOfOneShape(a: Identity, b: Identity): boolean {
  return a.timerClass === b.timerClass && sameLayout(a, b);
}
