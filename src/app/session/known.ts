import { type Change, differences, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';

/** What is known about the content of one memory of the connected timer. Times are milliseconds since 1970. */
export type Known =
  /** Nobody has read it since this timer was connected. */
  | { readonly state: 'unread' }
  /** A complete reading; `verified` when it was the read back of a write. */
  | { readonly state: 'read'; readonly program: TimerProgram; readonly at: number; readonly verified: boolean }
  /**
   * A write was interrupted, and no reading has shown its result since:
   * each field holds either its old or its wanted value.
   */
  | {
      readonly state: 'uncertain';
      readonly since: number;
      readonly before: TimerProgram;
      readonly readAt: number | null;
      readonly goal: TimerProgram;
    };

/** A memory of some timer whose content is uncertain. */
export interface Uncertain {
  /** The key of its record. */
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
 * The possible values of a field, each once: none when nothing is known, one after a reading, up to two after an
 * interrupted write. A value that was never read is left out.
 */
export function possibleValues(known: Known, field: ProgramField): readonly number[] {
  if (known.state === 'unread') return [];
  const programs = known.state === 'read' ? [known.program] : [known.before, known.goal];
  return [...new Set(programs.map((program) => valueAt(program, field)).filter((value) => value !== null))];
}

/** The fields that may have either of two values, DT and motor stop first. */
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
