import { screen } from '@testing-library/preact';
import { expect, it } from 'vitest';
import { strayed } from '../../../src/app/write/sending.js';
import { TimerError, type WriteReport } from '../../../src/client/index.js';
import { en } from '../../tools/en.js';
import { connected, press, startWrite, type } from '../screen.js';

it('a write during which another memory became current says that values may be in that one', async () => {
  const { timer } = await connected();
  await type('DT time', '4:00');
  await type('Function 2, S1', '7');
  timer.core.onAnswer = ({ name }) => {
    if (name === 'SETTIMERS') timer.core.memory = 2;
  };
  await press('Write 2 changes…');
  await startWrite();
  expect(screen.getByRole('dialog', { name: en.write.title }).textContent).toContain(
    'M3 became current during the write. Some of the values may be in M3 now.',
  );
});

it('a write that changes nothing has sent no value into any memory', () => {
  const value = { field: { kind: 'time', slot: 1 }, wanted: 1, held: null, status: 'unknown', asked: true } as const;
  const report: WriteReport = {
    result: 'unknown',
    values: [value],
    held: null,
    asked: 1,
    acknowledged: 0,
    repeats: 0,
    stopped: new TimerError('other-memory', 'memory 2 is current, not 0', { expected: 0, found: 2 }),
  };
  expect(strayed([report])).toBe(2);
  expect(strayed([{ ...report, values: [{ ...value, asked: false }] }])).toBeNull();
  expect(strayed([{ ...report, values: [] }])).toBeNull();
  expect(strayed([])).toBeNull();
});
