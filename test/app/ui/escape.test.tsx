import { act, screen } from '@testing-library/preact';
import { expect, it } from 'vitest';
import { en } from '../../tools/en.js';
import { type AppBench, idle } from '../bench/bench.js';
import { button, connected, goTo, press, type } from '../screen.js';

/** Everything that a key must not change. */
function state({ session, timer, editor, store }: AppBench): string {
  const { core } = timer;
  return JSON.stringify([
    session.link.state.value.status,
    core.answered.length,
    core.memory,
    core.memories,
    editor.working.value,
    [store.backups, store.unfinished, store.models, store.settings, store.flights].map(({ records }) => [...records]),
    session.runner.job.value?.stopping,
  ]);
}

/** As a browser tells a dialog of the key. */
async function pressEscape(): Promise<void> {
  act(() => void screen.getByRole('dialog').dispatchEvent(new Event('cancel', { cancelable: true })));
  await idle(0);
}

const SHORT = 2000;

it.each<[dialog: string, open: (app: AppBench) => Promise<void>]>([
  ['Write to the timer', () => press('Write…')],
  [
    'Before you disconnect',
    async (app) => {
      app.editor.revertAll();
      for (const memory of app.timer.core.memories) memory.times[10] = SHORT;
      await press('Read again');
      await press('Disconnect');
    },
  ],
  ['Share', () => press('Share…')],
  [
    'Delete everything on this device',
    async () => {
      await goTo('settings');
      await press(en.erase.open);
    },
  ],
  ['Save', () => press(en.library.save.open)],
])('Escape changes nothing: %s', async (name, open) => {
  const app = await connected();
  await type('DT time', '4:00');
  await open(app);
  expect(screen.getByRole('dialog').textContent).toContain(name);
  const before = state(app);
  await pressEscape();
  await idle();
  expect([state(app), screen.queryByRole('dialog')]).toEqual([before, null]);
});

it('Escape changes nothing: a write in progress goes on to its end', async () => {
  const app = await connected();
  await type('DT time', '4:00');
  await press('Write…');
  app.session.safety.confirm();
  await idle(0);
  // Asleep, so that the write is still in progress when the key comes.
  app.timer.core.onAnswer = ({ name }) => name === 'SETTIMERS' && app.timer.core.sleep();
  button(/^Write 1 change$/).click();
  await idle(500);
  const before = state(app);
  await pressEscape();
  expect([app.write.current.value?.step, state(app)]).toEqual(['running', before]);
  app.timer.core.onAnswer = undefined;
  app.timer.core.press();
  await idle();
  expect(app.write.current.value).toMatchObject({ step: 'done', ends: [{ state: 'verified' }] });
});
