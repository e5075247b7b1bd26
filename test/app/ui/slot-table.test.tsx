import { render, screen } from '@testing-library/preact';
import { expect, test } from 'vitest';
import { TimesTable } from '../../../src/app/ui/slot-table.js';
import { programOf } from '../programs.js';

test.each([
  ['Q', 1050, 'DT', '10.50'],
  ['B', 18_000, 'DT min', '3:00'],
])(
  'the start of an F1%s comes at 0, whatever the first time means there, DT %i: %s %s',
  (timerClass, dt, name, text) => {
    render(<TimesTable program={programOf(timerClass, [1000, 30, dt])} caption="A program" />);
    const rows = screen.getAllByRole('row').map((row) => [...row.children].slice(0, 2).map((cell) => cell.textContent));
    expect(rows).toEqual([
      ['Function', 'Time\u00a0s'],
      ['Start', '0'],
      ['Function 1', '0.30'],
      [name, text],
    ]);
  },
);
