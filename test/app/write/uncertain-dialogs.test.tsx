import { fireEvent, screen } from '@testing-library/preact';
import { expect, it } from 'vitest';
import { type TimerProgram, withValue } from '../../../src/program/index.js';
import { en } from '../../tools/en.js';
import { type AppBench, idle } from '../bench/bench.js';
import { connected, field, goTo, press, type } from '../screen.js';

const SENTENCE = 'It is not known what M2 holds: DT is 3:00 min or 6:00 min. Do not fly before it is read.';

/** Every dialog that can lie over the band, and the way to it. */
const DIALOGS: readonly [title: string, open: (app: AppBench) => Promise<unknown>][] = [
  [
    en.write.title,
    async () => {
      await type('DT time', '4:00');
      await press('Write…');
    },
  ],
  [
    'Paste',
    async () => {
      const cell = field('Function 2, S1');
      cell.focus();
      const event = new Event('paste', { bubbles: true, cancelable: true });
      fireEvent(cell, Object.assign(event, { clipboardData: { getData: () => '1\t2\n3\t4' } }));
      await idle(0);
    },
  ],
  [
    en.nextFlight.leaving.title,
    async (app) => {
      for (const memory of app.timer.core.memories) memory.times[10] = 2000;
      await press('Read again');
      await press('Disconnect');
    },
  ],
  [
    'Delete everything on this device',
    async () => {
      await goTo('settings');
      await press(en.erase.open);
    },
  ],
];

it.each(DIALOGS)('“%s” says what is not known, like the band that it covers', async (title, open) => {
  const app = await connected();
  const { session, editor } = app;
  const before = { ...(editor.baseline.value as TimerProgram), memory: 1 };
  await session.knowledge.begin(before, withValue(before, { kind: 'time', slot: 10 }, 36_000));
  session.knowledge.jobOver();
  await open(app);
  const dialog = screen.getByRole('dialog', { name: title });
  expect(dialog.querySelector('.dialog-head .uncertain')?.textContent).toBe(SENTENCE);
});
