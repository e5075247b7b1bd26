import { render, screen } from '@testing-library/preact';
import { describe, expect, it } from 'vitest';
import { INTERVAL_COLUMN, TIME_COLUMN } from '../../../src/app/editing/grid.js';
import { ProgramGrid } from '../../../src/app/timeline/program-grid.js';
import type { TimerProgram } from '../../../src/program/index.js';
import { SETTING } from '../../program/library-examples.js';
import { en } from '../../tools/en.js';
import { programOf } from '../programs.js';

function linesOf(program: TimerProgram, other: TimerProgram = program): string[] {
  const columns = [TIME_COLUMN, INTERVAL_COLUMN, ...program.positions.map((_, servo) => 2 + servo)];
  const { unmount } = render(<ProgramGrid {...{ program, other, columns }} caption="A program" />);
  const [, ...rows] = screen.getAllByRole('row');
  const lines = rows.map((row) => [...row.children].map(({ textContent }) => textContent).join(' | '));
  unmount();
  return lines;
}

describe('the grid of a program', () => {
  it('has a row for each slot, and the motor stop where it comes in the order of time', () => {
    expect(linesOf(SETTING.program)).toEqual([
      'Start | 0 |  | 15 | 15',
      'Function 1 | 0.3 s | 0.30 | 25 | 15',
      'Motor stop | 10.0 s |  |  | ',
      'Function 2 | 10.5 s | 10.20 | 40 | 60',
      'Function 3 | 13.0 s | 2.50 | 55 | 70',
      'DT | 3:00 min | 2:47 | 115 | 115',
    ]);
    const names = (program: TimerProgram) => linesOf(program).map((line) => line.split(' | ')[0]);
    expect(names(programOf('Q', [20_000, 30, 18_000], [[1, 2, 3]]))).toEqual([
      ...['Start', 'Function 1', 'DT', en.program.motorStop],
    ]);
    expect(names(programOf('Q', [30, 30, 18_000], [[1, 2, 3]])), 'at an equal time it comes first').toEqual([
      ...['Start', en.program.motorStop, 'Function 1', 'DT'],
    ]);
    expect(linesOf(programOf('B', [0, 300, 200, 18_000], [[1, 2, 3, 4]]))[2]).toBe('Function 2 | 2.00 s | -1.00 | 3');
  });

  it('has a reserved time at the start only where two programs differ in it', () => {
    const [one, two] = [1000, 1234].map((first) => programOf('B', [first, 30, 18_000], [[1, 2, 3]]));
    expect(linesOf(one as TimerProgram)[0]).toBe('Start | 0 |  | 1');
    expect(linesOf(one as TimerProgram, two)[0]).toBe('Start | 10.00 s 12.34 s |  | 1');
  });
});
