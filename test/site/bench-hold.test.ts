import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { type AppOptions, AppPage, middleOf } from './app-page.js';
import { fingerOn, PHONE } from './page.js';

/** The bench, with servos that follow at function 2, whose positions are all 35. */
async function following(options: AppOptions = {}): Promise<AppPage> {
  const app = await AppPage.connected({ bench: { timing: true }, ...options });
  await app.follow('Function 2');
  return app;
}

/** The positions of a servo that went to the timer, in their order. */
const stored = (app: AppPage): Promise<number[]> =>
  app.bench(({ adapter }) =>
    adapter.timer.core.answered.flatMap((request) => (request.name === 'SETSERVO' ? [request.position] : [])),
  );

const stands = (app: AppPage): Promise<number[]> => app.bench(({ adapter }) => adapter.timer.core.servos);

/** Waits until the servo has gone at least so far, releases the key, and looks what went to the timer. */
async function expectSteps(app: AppPage, name: string, far: number, release: () => Promise<unknown>): Promise<number> {
  await expect.poll(async () => (await stored(app)).at(-1) ?? 0).toBeGreaterThanOrEqual(far);
  await release();
  const last = Number(await app.valueOf(name));
  await expect.poll(async () => (await stands(app))[Number(name.at(-1)) - 1]).toBe(last);
  const began = (await stored(app))[0] ?? 0;
  expect(await stored(app), 'each step, in order, and none after the key was released').toEqual(
    Array.from({ length: last - began + 1 }, (_, i) => began + i),
  );
  return last;
}

test('a step key that is held by mouse or Space moves its servo step by step, each hold as one step to undo', async () => {
  const app = await following();
  const { page } = app;
  await app.button('+1: Function 2, S1').hover();
  await page.mouse.down();
  const first = await expectSteps(app, 'Function 2, S1', 40, () => page.mouse.up());
  await app.text('was 35').waitFor();
  await app.button('+1: Function 2, S1').focus();
  await page.keyboard.down(' ');
  await expectSteps(app, 'Function 2, S1', first + 4, () => page.keyboard.up(' '));

  await app.goTo('Program');
  await app.undo.click();
  expect(await app.valueOf('Function 2, S1')).toBe(String(first));
  await app.undo.click();
  expect(await app.valueOf('Function 2, S1')).toBe('35');
  await expect.poll(() => stands(app)).toEqual([35, 35, 35]);
});

test('on the smallest phone a finger holds the key of the servo that it has chosen, under its whole name', async () => {
  const app = await following({
    ...PHONE,
    viewport: { width: 320, height: 640 },
    before: () => {
      if (location.protocol === 'about:') return;
      const names = ['Tailplane', 'Руль направления', 'מייצב אופקי ארוך'];
      const uses = names.map((name) => ({ duty: 'other', name, low: 0, high: 130, reversed: false }));
      localStorage.setItem('sidus-timer/servos/timer/Q/536/10/3', JSON.stringify(uses));
    },
  });
  const { page } = app;
  for (const [servo, name] of ['Tailplane', 'Руль направления', 'מייצב אופקי ארוך'].entries()) {
    await page.getByRole('radio', { name: `S${servo + 1} 35` }).tap({ force: true });
    const shown = page.getByRole('group', { name: `Function 2, S${servo + 1} ${name}` }).locator('bdi');
    expect(await shown.textContent()).toBe(name);
    const [left, right] = await shown.evaluate((each) => {
      const range = document.createRange();
      range.selectNodeContents(each);
      const { left, right } = range.getBoundingClientRect();
      return [left, right];
    });
    expect([(left ?? -1) >= 0, (right ?? 321) <= 320], name).toEqual([true, true]);
    await app.expectNoSidewaysScrolling();
  }
  await page.getByRole('radio', { name: 'S2 35' }).tap({ force: true });
  const touch = await fingerOn(page);
  await touch('touchStart', await middleOf(app.button('+1: Function 2, S2')));
  const last = await expectSteps(app, 'Function 2, S2', 40, () => touch('touchEnd'));
  await app.text('was 35').waitFor();
  await page.getByRole('radio', { name: `S2 ${last}` }).waitFor({ state: 'attached' });
  await app.type('Function 2, S2', '30');
  await expect.poll(() => stands(app)).toEqual([35, 30, 35]);
});

test('a tab that is hidden ends following: nothing that is changed after that goes to the timer', async () => {
  const app = await following();
  for (const hidden of [true, false]) {
    await app.page.evaluate((isHidden) => {
      Object.defineProperty(document, 'hidden', { value: isHidden, configurable: true });
      document.dispatchEvent(new Event('visibilitychange'));
    }, hidden);
    await app.text(en.bench.ended.over).waitFor();
    await app.isReady();
  }
  await app.page.getByRole('switch', { checked: false }).waitFor();
  await app.button('+1: Function 2, S1').click();
  await app.goTo('Program');
  // A whole reading gives enough time for anything that would be sent.
  await app.readAgain();
  expect(await stored(app)).toEqual([]);
  await app.text(/^1 change$|, 1 waits for Write$/).waitFor();
});
