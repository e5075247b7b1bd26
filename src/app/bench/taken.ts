import { type Change, differences, fieldKey, type TimerProgram } from '../../program/index.js';
import type { TimerConnection } from '../../serial/index.js';
import { withValues } from '../editing/edit.js';
import type { JobContext } from '../timer/job-runner.js';
import type { PendingPosition } from './followed-edits.js';

/** What a timer holds in place of what it acknowledged, and what changed beside it. */
export interface Unlike {
  /** What was read back. */
  readonly held: TimerProgram;
  /** From what it should hold to what it holds; null when it took the position. */
  readonly notTaken: Change | null;
  /** Values that nobody touched: from what they were to what they are. */
  readonly beside: readonly Change[];
}

/**
 * Whether one position shows that the timer does what it acknowledges. A position whose servo and function have the
 * same number does not: function and servo may be exchanged on the way (row 9 of docs/protocol.md).
 */
export function isProof({ field }: PendingPosition): boolean {
  return field.servo !== field.slot;
}

/**
 * Reads back what the timer has made of one position.
 * @param before what it held.
 * @returns null when it took that position and nothing else has changed.
 */
export async function readBack(
  { client }: TimerConnection,
  options: JobContext,
  before: TimerProgram,
  sent: PendingPosition,
): Promise<Unlike | null> {
  const { signal } = options;
  const held = await client.readProgram({ signal });
  options.stillOn();
  // A value that is not known this time says nothing.
  const changes = differences(withValues(before, [sent]), held).filter(({ from, to }) => from !== null && to !== null);
  if (changes.length === 0 && held.memory === before.memory) return null;
  const key = fieldKey(sent.field);
  return {
    held,
    notTaken: changes.find(({ field }) => fieldKey(field) === key) ?? null,
    beside: changes.filter(({ field }) => fieldKey(field) !== key),
  };
}
