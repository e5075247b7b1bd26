import { type Change, differences, fieldKey, type ProgramField, type TimerProgram, valueAt } from '../program/index.js';
import type { TimerError } from './errors.js';

/** What became of one value. */
export interface ValueReport {
  /** Which value it is. */
  readonly field: ProgramField;
  /** What the timer should hold. */
  readonly wanted: number | null;
  /** The value in a fresh read; null when it is not known. */
  readonly held: number | null;
  /**
   * `verified`: a fresh read gave the wanted value. `differs`: it gave another one. `unknown`: there was no fresh read.
   */
  readonly status: 'verified' | 'differs' | 'unknown';
  /** False for a value that should not have changed but did. `verified` then means that it was put back. */
  readonly asked: boolean;
}

/** What became of a write. */
export interface WriteReport {
  /** `verified` only when a fresh read equals the whole wanted program: the changed values and all others. */
  readonly result: 'verified' | 'differs' | 'unknown';
  /**
   * How many values were to be changed. 0: the goal is what the timer held, so nothing was written, and `verified` says
   * only that it still holds that.
   */
  readonly asked: number;
  /** All values that were to be changed, and all that changed without being asked. */
  readonly values: readonly ValueReport[];
  /** What the timer held at the last fresh read; null when there was none after the first SET request. */
  readonly held: TimerProgram | null;
  /** SET requests that were acknowledged. */
  readonly acknowledged: number;
  /** Requests that were repeated, fences included. */
  readonly repeats: number;
  /**
   * What stopped the write or the read back; null when nothing did. With `other-memory` the memory that was found may
   * have taken some of the values: a request does not say for which memory it is.
   */
  readonly stopped: TimerError | null;
}

/** Whether a memory holds what was believed. An idle throttle that was not known may have any value. */
export function isHeld(believed: TimerProgram, held: TimerProgram): boolean {
  return differences(believed, held).every(({ from }) => from === null);
}

/** Values that differ from the goal although nobody asked to change them. */
export function unasked(held: TimerProgram, goal: TimerProgram, asked: readonly Change[]): Change[] {
  const changed = new Set(asked.map(({ field }) => fieldKey(field)));
  return differences(held, goal).filter(({ field, to }) => to !== null && !changed.has(fieldKey(field)));
}

/**
 * Compares the goal with the read back.
 * @param changedUnasked the values that changed without being asked.
 * @param held what the last fresh read gave; null when there was none.
 */
export function verdict(
  goal: TimerProgram,
  asked: readonly Change[],
  changedUnasked: Iterable<ProgramField>,
  held: TimerProgram | null,
): Pick<WriteReport, 'result' | 'asked' | 'values'> {
  const judge = (field: ProgramField, isAsked: boolean): ValueReport => {
    const wanted = valueAt(goal, field);
    const found = held && valueAt(held, field);
    const status = found === null ? 'unknown' : found === wanted ? 'verified' : 'differs';
    return { field, wanted, held: found, status, asked: isAsked };
  };
  const values = [
    ...asked.map(({ field }) => judge(field, true)),
    ...[...changedUnasked].map((field) => judge(field, false)),
  ];
  const told = { asked: asked.length, values };
  if (values.some(({ status }) => status === 'differs')) return { result: 'differs', ...told };
  const isKnown = held !== null && values.every(({ status }) => status === 'verified');
  return { result: isKnown ? 'verified' : 'unknown', ...told };
}
