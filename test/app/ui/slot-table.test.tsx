import { render, screen } from '@testing-library/preact';
import { expect, test } from 'vitest';
import { TimesTable } from '../../../src/app/ui/slot-table.js';
import { programOf } from '../programs.js';

test.each([
  ['Q', '0.3 s'],
  ['B', '0.30 s'],
])('the start of an F1%s comes at 0, whatever the first time means there', (timerClass, first) => {
  render(<TimesTable program={programOf(timerClass, [1000, 30, 1050])} caption="A program" />);
  const rows = screen.getAllByRole('row').map((row) => [...row.children].slice(0, 2).map((cell) => cell.textContent));
  expect(rows).toEqual([
    ['Function', 'Time'],
    ['Start', '0'],
    ['Function 1', first],
    ['DT', '10.5 s'],
  ]);
});
