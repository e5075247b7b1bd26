import { type Change, type TimerProgram, valueAt } from '../../program/index.js';
import { messages } from '../messages/index.js';
import { ComparisonGrid } from './comparison-grid.js';
import { ValueTable } from './value-table.js';

/** More values than these are found sooner where they stand in the program. */
export const LONG_LIST = 8;

interface DifferenceProps {
  /** What the timer holds, and what it shall hold. */
  readonly before: TimerProgram;
  readonly goal: TimerProgram;
  readonly changes: readonly Change[];
}

/** What a write would change: value by value, and where that is long, in the grid of the program. */
export function Difference({ before, goal, changes }: DifferenceProps) {
  const { from, to } = messages.value.write;
  // What is not known of the timer, the grid could not show.
  const isKnown = changes.every((change) => change.from !== null && change.from === valueAt(before, change.field));
  if (changes.length > LONG_LIST && isKnown)
    return <ComparisonGrid first={goal} second={before} names={[to, from]} replaces />;
  return (
    <ValueTable
      identity={goal.identity}
      names={[from, to]}
      rows={changes.map((change) => ({ field: change.field, values: [change.from, change.to] }))}
      lastCounts
    />
  );
}
