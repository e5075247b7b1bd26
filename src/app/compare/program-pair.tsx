import type { ComponentChildren } from 'preact';
import { useLayoutEffect, useMemo } from 'preact/hooks';
import { type Change, differences, type TimerProgram } from '../../program/index.js';
import { messages } from '../messages/index.js';
import { moreMessages } from '../messages/more.js';
import { ProgramGrid } from '../timeline/program-grid.js';
import { Timeline } from '../timeline/timeline.js';
import { TimelineModel } from '../timeline/view-model.js';
import { LONG_LIST } from '../write/difference.js';
import { ValueTable } from '../write/value-table.js';
import './program-pair.css';

interface ProgramPairProps {
  /** Both have the same layout. */
  readonly first: TimerProgram;
  readonly second: TimerProgram;
  /** The names of the two. */
  readonly names: readonly [string, string];
  /** The name of the picture. */
  readonly title: string;
  /** A control for each value that differs. With it, the values stand one below the other, however many there are. */
  readonly actionOf?: ((change: Change) => ComponentChildren) | undefined;
  readonly children?: ComponentChildren;
}

/** Two programs: what differs, in figures and over time. */
export function ProgramPair({ first, second, names, title, actionOf, children }: ProgramPairProps) {
  const { write } = messages.value;
  const { overview: words } = moreMessages.value;
  const changes = differences(first, second);
  const grid = changes.length > LONG_LIST && !actionOf;
  const servo = firstServo(changes);
  const model = useMemo(() => new TimelineModel(), []);
  // A small difference shows only in the tall lane. The pilot may then choose another one.
  useLayoutEffect(() => model.bringToFront(servo), [model, servo]);
  return (
    <div class="stack gap-4 program-pair">
      <div class="stack gap-3 panel pair-values">
        <p role="status">
          <strong>{changes.length === 0 ? words.same : words.differs({ count: changes.length })}</strong>
        </p>
        {children}
        {grid && (
          <ProgramGrid
            program={first}
            other={second}
            caption={write.sideBySide({ names: names.join(', ') })}
            names={names}
          />
        )}
        {!grid && changes.length > 0 && (
          <ValueTable
            identity={first.identity}
            names={names}
            rows={changes.map((change) => ({
              field: change.field,
              values: [change.from, change.to],
              note: actionOf?.(change),
            }))}
          />
        )}
      </div>
      <Timeline program={first} overlay={{ program: second, name: names[1] }} title={title} model={model} />
    </div>
  );
}

/** The first servo whose positions differ; the first of all if none do. */
function firstServo(changes: readonly Change[]): number {
  const servos = changes.flatMap(({ field }) => (field.kind === 'position' ? [field.servo] : []));
  return servos.length === 0 ? 0 : Math.min(...servos);
}
