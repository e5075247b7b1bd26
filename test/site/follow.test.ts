import type { Locator } from 'playwright';
import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';

/** One more step, by the keys of the table. */
async function stepUp(app: AppPage): Promise<void> {
  await app.table.getByRole('textbox', { name: 'Function 2, S1', exact: true }).focus();
  await app.page.keyboard.press('Alt+ArrowUp');
}

/** Where the timer has moved its servos, and where each of them stands. */
const stand = (app: AppPage): Promise<[slot: number, servos: number[]]> =>
  app.bench(({ adapter }) => [adapter.timer.core.slot, adapter.timer.core.servos]);

const row = (app: AppPage, name: string): Locator => app.table.getByRole('row', { name: new RegExp(`^${name}`) });

const held = (app: AppPage): Promise<number | undefined> => app.bench(({ content }) => content.positions[0]?.[2]);

test('while following, a changed position is stored and its servo moves, until the tab is hidden', async () => {
  const app = await AppPage.open({ bench: { granted: true } });
  await app.connect();
  await app.goTo('Bench');
  const followSwitch = app.page.getByRole('switch', { name: en.bench.follow, exact: true });
  await app.page.getByRole('checkbox', { name: 'The propeller is off' }).check();
  await app.button('Function 2').click();
  await app.text('Servos at function 2').first().waitFor();
  await followSwitch.click();
  await expect.poll(() => followSwitch.getAttribute('aria-checked')).toBe('true');

  await app.goTo('Program');
  await row(app, 'Function 2').getByText('servos here').waitFor();
  await stepUp(app);
  await expect.poll(() => held(app)).toBe(36);
  await app.text('1 tried in the timer').waitFor();
  await expect.poll(() => stand(app)).toEqual([2, [36, 35, 35]]);
  expect(await app.sets()).toEqual(['SETSERVO']);

  // Another tab is in front of this one.
  await app.page.evaluate(() => {
    Object.defineProperty(document, 'hidden', { value: true, configurable: true });
    Object.defineProperty(document, 'visibilityState', { value: 'hidden', configurable: true });
    document.dispatchEvent(new Event('visibilitychange'));
  });
  await app.text(en.bench.ended.over).waitFor();
  await app.isReady();
  await app.page.evaluate(() => {
    Reflect.deleteProperty(document, 'hidden');
    Reflect.deleteProperty(document, 'visibilityState');
    document.dispatchEvent(new Event('visibilitychange'));
  });
  await app.goTo('Bench');
  await expect.poll(() => followSwitch.getAttribute('aria-checked')).toBe('false');
  await app.goTo('Program');
  await stepUp(app);
  // A whole reading gives enough time for anything that would be sent.
  await app.readAgain();
  expect(await app.sets()).toEqual(['SETSERVO']);
  await app.text(/^1 change$|, 1 waits for Write$/).waitFor();
});
