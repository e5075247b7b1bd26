import type { TimerErrorCode, TimerErrorDetails, WriteReport } from '../../client/index.js';
import {
  type Change,
  checkProgram,
  differences,
  type Finding,
  type Model,
  type ProgramField,
  sameKind,
  type TimerProgram,
  valueAt,
} from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import { withValues } from '../editing/edit.js';
import type { Crossing } from '../records/crossing.js';
import type { Backup } from '../storage/index.js';
import type { RoundTrip } from '../work/interrupted-jobs.js';

/** What a write is to do. */
export type Plan = EditsPlan | MemoriesPlan;

/** A plan that writes what is on the screen. What is copied or restored was in a memory before. */
type ScreenPlan = EditsPlan | Extract<MemoriesPlan, { kind: 'screen' }>;

/**
 * Writes what was edited on the screen into its memory, which flies next. `only`: nothing but these fields; the other
 * edits wait.
 */
export interface EditsPlan {
  readonly kind: 'edits';
  readonly only?: readonly ProgramField[];
}

/** A plan for memories that need not be current. They are selected one after the other, and then the current one. */
export type MemoriesPlan =
  /** Copies the content of a memory, read for this purpose, into another one. */
  | { readonly kind: 'copy'; readonly from: number; readonly to: number }
  /** The same with the program on the screen. `own`: its changes are of that memory. */
  | { readonly kind: 'screen'; readonly to: number; readonly own: boolean }
  | { readonly kind: 'restore'; readonly backups: readonly Backup[] };

/** What will be written into one memory, as the dialog shows it. */
export interface MemoryChange {
  /** Counted from 0; null for the current one where the timer does not say which that is. */
  readonly memory: number | null;
  /** What it holds, by the reading for the dialog. */
  readonly before: TimerProgram;
  readonly goal: TimerProgram;
  readonly changes: readonly Change[];
  /** The values that no request can carry: with one of them nothing is written. */
  readonly refusals: readonly Finding[];
}

/** What became of one memory that was to be written. */
export interface MemoryEnd {
  /** As in {@link MemoryChange}. */
  readonly memory: number | null;
  /**
   * `untouched`: nothing was written into it. `differs`: it was read back and holds something else. `unknown`: it was
   * not read back, or may have taken values of another memory.
   */
  readonly state: WriteReport['result'] | 'untouched';
  /** Null when it was not even compared. */
  readonly change: MemoryChange | null;
  /** Null when no value was to go out, or nobody knows. */
  readonly report: WriteReport | null;
}

/** The result of a write. */
export interface Outcome {
  readonly ends: readonly MemoryEnd[];
  /** What stopped it; null when nothing did. */
  readonly stopped: { readonly code: TimerErrorCode | 'unexpected'; readonly details: TimerErrorDetails } | null;
  /** Whether positions were not kept, perhaps because the servos did not move. */
  readonly notHeld: boolean;
  /** The memory, counted from 0, that may have taken values of another one; null for none. */
  readonly strayed: number | null;
}

/** What is about to be written: exactly this, or nothing. */
export interface Review {
  readonly step: 'review';
  readonly plan: Plan;
  /** It is written on this connection, or not at all. */
  readonly connection: TimerConnection;
  readonly changes: readonly MemoryChange[];
  /** The model that the timer belongs to, for a write of what is on the screen; null when it is not known. */
  readonly model: Model | null;
  /** Set when the values are of another model. */
  readonly crossing: Crossing | null;
  /** Why the difference is shown again: the timer, the edits or the model have changed since. Nothing was sent. */
  readonly moved: 'timer' | 'edits' | 'model' | null;
}

/** What came of it. */
export interface Done extends Outcome {
  readonly step: 'done';
  readonly plan: Plan;
  /** As it was reviewed. */
  readonly model: Model | null;
  /** Milliseconds since 1970. */
  readonly at: number;
  /**
   * Whether only its button closes the result, because the pilot has to see it: an Escape may be meant for something
   * else.
   */
  readonly stays: boolean;
}

/** The steps of a write, from the difference to the result. */
export type WriteStep =
  | Review
  /** Where the browser cannot keep a copy of a memory, the job asks the pilot before anything is sent into it. */
  | { readonly step: 'running'; readonly plan: Plan }
  | Done;

/** Whether everything went well. */
export function isGood({ stopped, ends }: Outcome): boolean {
  return stopped === null && ends.every(({ state }) => state === 'verified');
}

export function isOfScreen(plan: Plan): plan is ScreenPlan {
  return plan.kind === 'edits' || plan.kind === 'screen';
}

/** Whether it writes the changes on the screen into the memory that they are of. */
export function isOwn(plan: Plan): boolean {
  return plan.kind === 'edits' || (plan.kind === 'screen' && plan.own);
}

/** Whether it puts back what this memory held, and leaves all else on the screen for another write. */
export function isPart(plan: Plan): boolean {
  return plan.kind === 'edits' && plan.only !== undefined;
}

/** What a memory is to hold after a write of what is on the screen. */
export function goalOf(plan: ScreenPlan, before: TimerProgram, working: TimerProgram): TimerProgram {
  if (plan.kind === 'screen') return into(plan.to, working);
  if (!plan.only) return working;
  return withValues(
    before,
    plan.only.flatMap((field) => {
      const value = valueAt(working, field);
      return value === null ? [] : [{ field, value }];
    }),
  );
}

/** Whether the idle throttle belongs to a memory is not known: it is left as it is. */
function into(memory: number, program: TimerProgram): TimerProgram {
  return { ...program, memory, idleThrottle: null };
}

/** What the record of its round trip calls it. */
export function tripOf({ kind }: MemoriesPlan): RoundTrip {
  return { job: kind === 'restore' ? 'restore' : 'copy', memory: null };
}

/** The memories to read before it is known what a plan would change. Those that it writes come first. */
export function memoriesOf(plan: MemoriesPlan): readonly number[] {
  return plan.kind === 'copy' ? [...targetsOf(plan), plan.from] : targetsOf(plan);
}

/** The memories into which a plan writes. */
export function targetsOf(plan: MemoriesPlan): readonly number[] {
  if (plan.kind !== 'restore') return [plan.to];
  return plan.backups.flatMap(({ program: { memory } }) => (memory === null ? [] : [memory]));
}

/**
 * What a plan would change.
 * @param programs what the memories of {@link memoriesOf} hold, in that order.
 * @param working what is on the screen.
 * @returns null when a backup comes from another kind of timer.
 */
export function changesBy(
  plan: MemoriesPlan,
  programs: readonly TimerProgram[],
  working: TimerProgram,
): readonly MemoryChange[] | null {
  const pairs = targetsOf(plan).map((memory, index) => {
    const before = programs[index] as TimerProgram;
    if (plan.kind === 'screen') return { before, goal: goalOf(plan, before, working) };
    if (plan.kind === 'copy') return { before, goal: into(memory, programs.at(-1) as TimerProgram) };
    return { before, goal: (plan.backups.find(({ program }) => program.memory === memory) as Backup).program };
  });
  if (!pairs.every(({ before, goal }) => sameKind(before.identity, goal.identity))) return null;
  return pairs.map(({ before, goal }) => changeOf(before, goal));
}

/** What a memory that holds one program needs to hold another one. A value that the goal does not know stays. */
export function changeOf(before: TimerProgram, goal: TimerProgram): MemoryChange {
  const changes = differences(before, goal).filter(({ to }) => to !== null);
  // A position that stays as it is needs no request.
  const refusals = checkProgram(goal, { baseline: before }).filter(({ severity }) => severity === 'error');
  return { memory: goal.memory, before, goal, changes, refusals };
}
