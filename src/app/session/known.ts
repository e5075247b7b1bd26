import { type Change, differences, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';

/** What is known of what one memory of the timer at hand holds. Times are milliseconds since 1970. */
export type Known =
  /** Nobody has read it since this timer was connected. */
  | { readonly state: 'unread' }
  /** A reading gave all of it; `verified` when that was the reading back of a write. */
  | { readonly state: 'read'; readonly program: TimerProgram; readonly at: number; readonly verified: boolean }
  /**
   * A write was cut off, and no reading since has shown what came of it: each field holds what it held before, or what
   * it was to hold.
   */
  | {
      readonly state: 'uncertain';
      readonly since: number;
      readonly before: TimerProgram;
      readonly readAt: number | null;
      readonly goal: TimerProgram;
    };

/** A memory of some timer of which it is not known what it holds. */
export interface Uncertain {
  /** Of the record that is kept of it. */
  readonly key: string;
  readonly identity: Identity;
  /** Counted from 0; null for a timer that does not say which memory is current. */
  readonly memory: number | null;
  readonly simulated: boolean;
  readonly since: number;
  readonly before: TimerProgram;
  readonly readAt: number | null;
  readonly goal: TimerProgram;
}

/**
 * What a field of a memory may hold, each value once: none when nothing is known, two when a write of it was cut off;
 * not one that was never read.
 */
export function possibleValues(known: Known, field: ProgramField): readonly number[] {
  if (known.state === 'unread') return [];
  const programs = known.state === 'read' ? [known.program] : [known.before, known.goal];
  return [...new Set(programs.map((program) => valueAt(program, field)).filter((value) => value !== null))];
}

/**
 * The values that are one or the other: what was to be changed. DT and the motor stop come first, as the first to look
 * at.
 */
export function openValues({ before, goal }: Pick<Uncertain, 'before' | 'goal'>): readonly Change[] {
  const { timerClass, functions } = before.identity;
  const rank = ({ field }: Change): number => {
    if (field.kind !== 'time') return 2;
    if (field.slot === functions) return 0;
    return field.slot === 0 && timerClass === 'Q' ? 1 : 2;
  };
  const open = differences(before, goal).filter(({ to }) => to !== null);
  return open.sort((a, b) => rank(a) - rank(b));
}
