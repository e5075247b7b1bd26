import type { TimerErrorCode } from '../../client/index.js';
import {
  type Change,
  checkProgram,
  differences,
  type Finding,
  sameKind,
  type TimerProgram,
} from '../../program/index.js';
import type { Known } from '../session/known.js';
import type { Backup } from '../storage/index.js';

/** What to do with several memories. */
export type Plan = { readonly kind: 'back-up' } | WritingPlan;

/** A plan that writes. */
export type WritingPlan =
  /** Copies the content of a memory, read for this purpose, into another one. */
  | { readonly kind: 'copy'; readonly from: number; readonly to: number }
  | { readonly kind: 'restore'; readonly backups: readonly Backup[] };

/** What will be written into one memory, as the dialog shows it. */
export interface MemoryChange {
  /** Counted from 0. */
  readonly memory: number;
  /** What it holds, by the reading for the dialog. */
  readonly before: TimerProgram;
  readonly goal: TimerProgram;
  readonly changes: readonly Change[];
}

/** What one memory holds at the end of a job, as far as it is known. */
export interface MemoryEnd {
  /** Counted from 0. */
  readonly memory: number;
  /**
   * `untouched`: nothing was written into it. `differs`: it was read back and holds something else. `unknown`: nobody
   * has read it since the write.
   */
  readonly state: 'verified' | 'untouched' | 'differs' | 'unknown';
  readonly known: Known;
  /** Null when it was not even compared. */
  readonly change: MemoryChange | null;
}

/** The result of a job over several memories. */
export interface MemoriesOutcome {
  /** How many memories were read and kept. */
  readonly saved: number;
  /** Each memory that was to be written. */
  readonly ends: readonly MemoryEnd[];
  /** What stopped it; null when nothing did. */
  readonly stopped: TimerErrorCode | 'unexpected' | null;
  /** Whether positions were not kept, perhaps because the servos did not move. */
  readonly notHeld: boolean;
  /** The memory, counted from 0, that may have taken values of another one; null for none. */
  readonly strayed: number | null;
}

/** Whether everything went well. */
export function isGood({ stopped, ends }: MemoriesOutcome): boolean {
  return stopped === null && ends.every(({ state }) => state === 'verified');
}

/** The memories to read before it is known what a plan would change. Those that it writes come first. */
export function memoriesOf(plan: WritingPlan): readonly number[] {
  return plan.kind === 'copy' ? [...targetsOf(plan), plan.from] : targetsOf(plan);
}

/** The memories into which a plan writes. */
export function targetsOf(plan: WritingPlan): readonly number[] {
  if (plan.kind === 'copy') return [plan.to];
  return plan.backups.flatMap(({ program: { memory } }) => (memory === null ? [] : [memory]));
}

/**
 * What a plan would change.
 * @param programs what the memories of {@link memoriesOf} hold, in that order.
 * @returns null when a backup comes from another kind of timer.
 */
export function changesBy(plan: WritingPlan, programs: readonly TimerProgram[]): readonly MemoryChange[] | null {
  const pairs = targetsOf(plan).map((memory, index) => {
    const before = programs[index] as TimerProgram;
    const goal =
      plan.kind === 'copy'
        ? // Whether the idle throttle belongs to a memory is not known: it is left as it is.
          { ...(programs.at(-1) as TimerProgram), memory, idleThrottle: null }
        : (plan.backups.find(({ program }) => program.memory === memory) as Backup).program;
    return { memory, before, goal };
  });
  if (!pairs.every(({ before, goal }) => sameKind(before.identity, goal.identity))) return null;
  return pairs.map(({ memory, before, goal }) => {
    const changes = differences(before, goal).filter(({ to }) => to !== null);
    return { memory, before, goal, changes };
  });
}

/** The values that no request can carry. A position that stays as it is needs no request. */
export function refusalsOf({ before, goal }: MemoryChange): readonly Finding[] {
  return checkProgram(goal, { baseline: before }).filter(({ severity }) => severity === 'error');
}

/**
 * What a memory holds at the end of a job.
 * @param known what is known about it then.
 * @param begun whether writing into it had begun.
 */
export function endOf(memory: number, known: Known, change: MemoryChange | null, begun: boolean): MemoryEnd {
  return { memory, known, change, state: begun && change ? stateOf(known, change) : 'untouched' };
}

function stateOf(known: Known, { before }: MemoryChange): MemoryEnd['state'] {
  if (known.state !== 'read') return 'unknown';
  if (known.verified) return 'verified';
  return differences(before, known.program).length === 0 ? 'untouched' : 'differs';
}
