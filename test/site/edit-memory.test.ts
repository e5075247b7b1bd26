import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { PHONE } from './page.js';

const LINE = `${en.nextFlight.onScreen({ memory: 'M3' })} ${en.nextFlight.other({ memory: 'M1' })}`;

/** The memory that is current in the timer, and DT of M1 and M3. */
const held = (app: AppPage) =>
  app.bench(({ adapter }) => {
    const { memory, memories } = adapter.timer.core;
    return [memory, ...memories.map(({ times }) => times[10])];
  });

test.each([
  ['a desktop', {}],
  ['a phone', PHONE],
])('on %s M3 is edited, survives a reload, and is written while M1 flies next', async (_, shape) => {
  const app = await AppPage.open({ ...shape, bench: { granted: true } });
  await app.connect();
  const before = await held(app);
  await app.lookAt('M3');
  await app.button('Edit M3').click();
  const line = app.page.locator('.next-flight');
  await line.getByText(LINE).waitFor();
  await app.field('DT time').fill('2:30');
  await app.field('DT time').press('Enter');
  await app.button('Write 1 change…').waitFor();

  await app.button('Show M1').click();
  await expect.poll(() => app.field('DT time').inputValue()).toBe('3:00');
  expect(await line.isVisible()).toBe(false);

  await app.page.reload();
  await app.connect();
  await expect.poll(() => app.field('DT time').inputValue()).toBe('3:00');
  await app.lookAt('M3');
  await app.button('Edit M3').click();
  await expect.poll(() => app.field('DT time').inputValue()).toBe('2:30');
  await app.button('Write 1 change…').click();
  await app.dialog.getByText(/At the end M1 flies next again\.$/).waitFor();
  await app.dialog.getByRole('checkbox', { name: 'The propeller is off' }).check();
  await app.dialog.getByRole('button', { name: 'Write 1 change' }).click();
  await app.result('Verified.');
  expect(await held(app)).toEqual(before.map((value, at) => (at === 3 ? 15_000 : value)));
  await app.dialog.getByRole('button', { name: 'Close' }).click();
  await line.getByText(LINE).waitFor();
});
