import type { Locator } from 'playwright';
import { expect, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { AppPage } from './app-page.js';

const followSwitch = (app: AppPage): Locator => app.page.getByRole('switch', { name: en.bench.follow, exact: true });

const isOn = async (app: AppPage): Promise<boolean> =>
  (await followSwitch(app).getAttribute('aria-checked')) === 'true';

/** Opens the bench, says that it is safe, moves the servos to function 2 and lets them follow. */
async function follow(app: AppPage): Promise<void> {
  await app.goTo('Bench');
  await app.page.getByRole('checkbox', { name: 'The propeller is off' }).check();
  await app.button('Function 2').click();
  await app.text('Servos at function 2').first().waitFor();
  await followSwitch(app).click();
  await expect.poll(() => isOn(app)).toBe(true);
  await app.goTo('Program');
}

async function following(): Promise<AppPage> {
  const app = await AppPage.open({ bench: { granted: true } });
  await app.connect();
  await follow(app);
  return app;
}

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

/** Following is off, and a change now is not sent. */
async function isOff(app: AppPage): Promise<void> {
  await app.goTo('Bench');
  await expect.poll(() => isOn(app)).toBe(false);
  await app.goTo('Program');
  const sets = await app.sets();
  await stepUp(app);
  // A whole reading gives enough time for anything that would be sent.
  await app.readAgain();
  expect(await app.sets()).toEqual(sets);
  await app.text(/^1 change$|, 1 waits for Write$/).waitFor();
}

test('while following, a changed position of the function where the servos stand is stored, and its servo moves', async () => {
  const app = await following();
  await row(app, 'Function 2').getByText('servos here').waitFor();
  await stepUp(app);
  await expect.poll(() => held(app)).toBe(36);
  await app.text('1 tried in the timer').waitFor();
  await expect.poll(() => stand(app)).toEqual([2, [36, 35, 35]]);
  expect(await app.sets()).toEqual(['SETSERVO']);
  await app.button(en.bench.stopFollowing).click();
  await isOff(app);
});

test('another function waits until the pilot sends the servos there', async () => {
  const app = await following();
  await app.type('Function 5, S2', '70');
  const offer = app.button('Move the servos to function 5');
  await offer.waitFor();
  expect([await stand(app), await app.sets()]).toEqual([[2, [35, 35, 35]], []]);
  await app.page.keyboard.press('Tab');
  await offer.press('Enter');
  await row(app, 'Function 5').getByText('servos here').waitFor();
  await app.text('1 tried in the timer').waitFor();
  await expect.poll(() => stand(app)).toEqual([5, [65, 70, 65]]);
  expect(await app.field('Function 5, S2').evaluate((field) => field === document.activeElement)).toBe(true);
  await app.type('Function 9 time', '25');
  await app.text('1 tried in the timer, 1 waits for Write').waitFor();
});

test('following stops when the tab is hidden', async () => {
  const app = await following();
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
  await isOff(app);
});

const returns: Readonly<Record<string, (app: AppPage) => Promise<void>>> = {
  'connected again': async (app) => {
    await app.button('Disconnect').click();
    await app.connect();
  },
  'plugged in again': async (app) => {
    await app.bench((bench) => bench.adapter.unplug());
    await app.says(en.link.lost.title);
    await app.bench((bench) => bench.replug());
    await app.isReady();
  },
  'loaded again': async (app) => {
    await app.reload();
    await app.connect();
  },
};

for (const [how, comeBack] of Object.entries(returns)) {
  test(`it is off when the timer was ${how}, and safety is asked again`, async () => {
    const app = await following();
    await comeBack(app);
    await app.goTo('Bench');
    expect(await isOn(app)).toBe(false);
    expect(await app.page.getByRole('checkbox', { name: 'The propeller is off' }).isChecked()).toBe(false);
    // The switch is marked as disabled, but a finger can still press it.
    await followSwitch(app).click({ force: true });
    expect(await isOn(app), 'the switch stays off before the tick').toBe(false);
    await isOff(app);
  });
}
