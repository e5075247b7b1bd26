import { type Change, differences, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import type { UnfinishedWrite } from '../storage/index.js';

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
  | ({ readonly state: 'uncertain' } & Pick<UnfinishedWrite, 'before' | 'readAt' | 'goal'>);

/** What a memory held at its last complete reading. */
export function lastRead(known: Known): TimerProgram | null {
  if (known.state === 'unread') return null;
  return known.state === 'read' ? known.program : known.before;
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
export function openValues({ before, goal }: Pick<UnfinishedWrite, 'before' | 'goal'>): readonly Change[] {
  const { timerClass, functions } = before.identity;
  const rank = ({ field }: Change): number => {
    if (field.kind !== 'time') return 2;
    if (field.slot === functions) return 0;
    return field.slot === 0 && timerClass === 'Q' ? 1 : 2;
  };
  const open = differences(before, goal).filter(({ to }) => to !== null);
  return open.sort((a, b) => rank(a) - rank(b));
}
