import { type Change, differences } from './difference.js';
import { fieldKey, type TimerProgram, valueAt } from './program.js';

/**
 * How far an interrupted write came, by a fresh reading.
 * - `nothing`: the timer holds what it held before.
 * - `part`: what it holds is explained by the old content and a part of the write.
 * - `all`: it holds everything that was wanted.
 * - `foreign`: it holds something that neither explains. This is another timer, or something else changed it.
 */
export type WriteExtent = 'nothing' | 'part' | 'all' | 'foreign';

/** What became of an interrupted write. */
export interface PartOfWrite {
  /** How far it came. */
  readonly extent: WriteExtent;
  /** The values that the write was to change and that are now as wanted. */
  readonly written: readonly Change[];
  /** The values that the write was to change and that are still as before. */
  readonly missing: readonly Change[];
  /**
   * The values that are neither as before nor as wanted.
   * `from` is what they were before, `to` what the timer holds now.
   */
  readonly foreign: readonly Change[];
}

/**
 * Tells what became of an interrupted write. Nothing on the wire identifies a timer, so this says only whether the
 * write explains what the timer holds. After `foreign` a person has to decide.
 * @param before what the timer held before the write.
 * @param goal what it was to hold. Null as idle throttle: the write did not touch it.
 * @param held what a fresh read gave.
 * @throws CodecError `wrong-count` when the three do not have the same slots and servos.
 */
export function partWritten(before: TimerProgram, goal: TimerProgram, held: TimerProgram): PartOfWrite {
  const asked = differences(before, goal).filter(({ to }) => to !== null);
  const foreign = differences(before, held).filter(
    ({ field, from, to }) => from !== null && to !== null && to !== valueAt(goal, field),
  );
  const strange = new Set(foreign.map(({ field }) => fieldKey(field)));
  const written = asked.filter(({ field, to }) => valueAt(held, field) === to);
  const missing = asked.filter(({ field, to }) => valueAt(held, field) !== to && !strange.has(fieldKey(field)));
  return { extent: extentOf(written.length, missing.length, foreign.length), written, missing, foreign };
}

function extentOf(written: number, missing: number, foreign: number): WriteExtent {
  if (foreign > 0) return 'foreign';
  if (missing === 0) return 'all';
  return written === 0 ? 'nothing' : 'part';
}
