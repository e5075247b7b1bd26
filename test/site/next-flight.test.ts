import { expect, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { AppPage } from './app-page.js';

test('the pilot looks at a memory, makes another fly next, and Disconnect repeats that', async () => {
  const app = await AppPage.open({ bench: { granted: true } });
  await app.connect();
  await app.bench(({ adapter }) => {
    const third = adapter.timer.core.memories[2];
    if (third) third.times[10] = 25_500;
    adapter.timer.core.answered.length = 0;
  });
  const current = (): Promise<number> => app.bench(({ adapter }) => adapter.timer.core.memory);
  /** The requests on the wire, SETMEMORY with its memory. */
  const asked = (): Promise<string[]> =>
    app.bench(({ adapter }) =>
      adapter.timer.core.answered.map((request) =>
        request.name === 'SETMEMORY' ? `SETMEMORY ${request.memory}` : request.name,
      ),
    );

  await app.lookAt('M3');
  await app.page.getByRole('heading', { name: 'M3 has not been read' }).waitFor();
  expect(await asked(), 'a tap on a memory sends nothing').toEqual([]);
  await app.button('Look at M3').click();
  await app.page.getByRole('heading', { name: /^M3, read \d\d:\d\d$/ }).waitFor();
  const held = app.page.getByRole('table', { name: en.program.tableCaption });
  await expect.poll(() => held.getByRole('row', { name: /^DT/ }).innerText()).toContain('4:15');
  expect(await current(), 'M1 is current again').toBe(0);
  const wire = await asked();
  expect(wire.filter((name) => !name.startsWith('GET'))).toEqual(['SETMEMORY 2', 'SETMEMORY 0']);
  expect(wire.slice(wire.indexOf('SETMEMORY 2'), wire.indexOf('SETMEMORY 0'))).toContain('GETTIMERS');
  expect(
    wire.slice(wire.indexOf('SETMEMORY 0')),
    'after going back, the timer is asked which memory is current',
  ).toContain('GETMEMORY');
  await app.page.getByRole('radio', { name: 'M1, flies next' }).waitFor({ state: 'attached' });

  await app.fly('M2');
  expect(await current()).toBe(1);
  await app.page.getByRole('status').getByText('M2 flies next. When you connected it was M1.').waitFor();
  await app.button('Disconnect').click();
  await app.button('Connect').waitFor();
  expect(await current(), 'nobody asks about a memory that was chosen').toBe(1);
});
