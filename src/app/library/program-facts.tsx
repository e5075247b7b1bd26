import type { ComponentChildren } from 'preact';
import type { TimerProgram } from '../../program/index.js';
import { messages } from '../messages/index.js';
import { ProgramGrid } from '../timeline/program-grid.js';
import { SmallLanes } from '../timeline/small-lanes.js';
import { KeyFigures } from '../ui/key-figures.js';
import './program-facts.css';

interface ProgramFactsProps {
  readonly program: TimerProgram;
  /** The names of its servos. */
  readonly names: readonly string[];
  /** What can be done with it. Stands above the table. */
  readonly children?: ComponentChildren;
}

/** A program to look at: its picture, its figures, and all values. */
export function ProgramFacts({ program, names, children }: ProgramFactsProps) {
  const { tableCaption } = messages.value.program;
  return (
    <>
      <div class="facts-lanes">
        <SmallLanes program={program} names={names} />
      </div>
      <KeyFigures program={program} />
      {children}
      {/* With many servos it scrolls, also by keyboard. */}
      <section class="facts-table" tabindex={0} aria-label={tableCaption}>
        <ProgramGrid program={program} caption={tableCaption} />
      </section>
    </>
  );
}
