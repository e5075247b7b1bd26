import { valueAt } from '../../program/index.js';
import { messages } from '../messages/index.js';
import { ProgramGrid } from '../timeline/program-grid.js';
import type { MemoryChange } from './plan.js';
import { ValueTable } from './value-table.js';

/** More values are easier to find at their places in the program. */
export const LONG_LIST = 8;

/** What a write would change: as a list, and when that is long, in the grid of the program. */
export function Difference({ before, goal, changes }: Pick<MemoryChange, 'before' | 'goal' | 'changes'>) {
  const { from, to, sideBySide } = messages.value.write;
  // The grid cannot show a value that is not known.
  const isKnown = changes.every((change) => change.from !== null && change.from === valueAt(before, change.field));
  if (changes.length > LONG_LIST && isKnown) {
    // A goal without an idle throttle leaves it as it is.
    const held = { ...goal, idleThrottle: goal.idleThrottle ?? before.idleThrottle };
    return (
      <ProgramGrid
        program={held}
        other={before}
        caption={sideBySide({ names: [to, from].join(', ') })}
        names={[to, from]}
        replaces
      />
    );
  }
  return (
    <ValueTable
      identity={goal.identity}
      names={[from, to]}
      rows={changes.map((change) => ({ field: change.field, values: [change.from, change.to] }))}
      lastCounts
    />
  );
}
