import { render, screen, within } from '@testing-library/preact';
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { Difference } from '../../../src/app/write/difference.js';
import { differences, type TimerProgram } from '../../../src/program/index.js';

const program = (timerClass: string, value: number, idleThrottle: number | null): TimerProgram => ({
  identity: { timerClass, firmware: '536', functions: 3, memories: 4, servos: 2 },
  memory: 0,
  times: [1, 2, 3, 4].map((slot) => slot * 100 + value),
  positions: [0, 1].map((servo) => [1, 2, 3, 4].map((slot) => servo * 10 + slot + value)),
  idleThrottle,
});

const shown = (): string[] => [...document.querySelectorAll('.differs')].map(({ textContent }) => textContent ?? '');

describe('what a write would change', () => {
  it('is listed value by value when the list is short', () => {
    const before = program('Q', 0, 30);
    const goal = { ...before, times: [100, 200, 300, 18_000] };
    render(<Difference {...{ before, goal }} changes={differences(before, goal)} />);
    expect(screen.getByRole('row', { name: /^DT/ }).textContent).toBe('DT4 s3:00 min');
    expect(shown()).toEqual([]);
  });

  it.each(['Q', 'B', 'E'])(
    'stands in the grid of the program of class %s, where that is long, with nothing left out',
    (timerClass) => {
      const [before, goal] = [program(timerClass, 0, 30), program(timerClass, 7, 40)];
      const changes = differences(before, goal);
      render(<Difference {...{ before, goal, changes }} />);
      expect(changes).toHaveLength(13);
      expect(shown()).toHaveLength(13);
      const throttle = within(screen.getByRole('row', { name: /^Idle throttle/ }));
      expect(throttle.getByText('40').closest('td')?.querySelector('small')?.textContent).toBe('30');
    },
  );

  it('shows in the grid what stays because the goal does not say it', () => {
    const [before, goal] = [program('Q', 0, 30), program('Q', 7, null)];
    const changes = differences(before, goal).filter(({ to }) => to !== null);
    render(<Difference {...{ before, goal, changes }} />);
    expect(shown()).toHaveLength(12);
    expect(screen.getByRole('row', { name: /^Idle throttle/ }).textContent).toBe('Idle throttle30');
  });

  it('marks each value that changes and no other, whichever these are', () => {
    const before = program('Q', 0, 30);
    const value = fc.integer({ min: 0, max: 130 });
    const rows = fc.tuple(
      fc.array(value, { minLength: 4, maxLength: 4 }),
      fc.array(value, { minLength: 4, maxLength: 4 }),
    );
    fc.assert(
      fc.property(rows, fc.array(value, { minLength: 4, maxLength: 4 }), (positions, times) => {
        const goal = { ...before, positions, times };
        const changes = differences(before, goal);
        const { unmount } = render(<Difference {...{ before, goal, changes }} />);
        const rowsShown = document.querySelectorAll('.difference tbody tr').length;
        expect(rowsShown + shown().length).toBe(changes.length);
        unmount();
      }),
      { numRuns: 30 },
    );
  });

  it('is listed, however long, when it is not known what the timer holds', () => {
    const [before, goal] = [program('Q', 0, null), program('Q', 7, 40)];
    const changes = differences(before, goal).map((change) => ({ ...change, from: null }));
    render(<Difference {...{ before, goal, changes }} />);
    expect([document.querySelectorAll('.difference tbody tr').length, shown().length]).toEqual([changes.length, 0]);
  });
});
