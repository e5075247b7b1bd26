import type { Locator } from 'playwright';
import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage, edgesOf, middleOf } from './app-page.js';
import { fingerOn, PHONE } from './page.js';
import { showTheme } from './themes.js';

/** The sheet of keys that opens for a field. */
const keysFor = (app: AppPage, field: string): Locator =>
  app.page.getByRole('region', { name: `Keys for ${field}`, exact: true });

test('a finger that moves up over the field with the focus scrolls the page, and changes nothing', async () => {
  const app = await AppPage.open({ bench: {}, ...PHONE });
  await app.button('Connect').tap();
  await app.hasRead();
  const { page } = app;
  const touch = await fingerOn(page);
  const field = app.field('Function 2, S2');
  /** Taps wherever the field is, whether it takes the focus or not. */
  const tap = async (): Promise<void> => {
    await field.scrollIntoViewIfNeeded();
    const { x, y } = await middleOf(field);
    await page.touchscreen.tap(x, y);
  };
  /** How far down on the screen it is: where the page was scrolled to, whatever grew above it. */
  const top = async (): Promise<number> => (await edgesOf(field)).top;

  await tap();
  const before = await top();
  const { x, y } = await middleOf(field);
  await touch('touchStart', { x, y });
  for (let gone = 2; gone <= 200; gone += 2) await touch('touchMove', { x: x + 0.15 * gone, y: y - gone });
  await touch('touchEnd');
  await expect.poll(top).toBeLessThan(before - 100);
  await expect
    .poll(async () => [await field.inputValue(), await page.evaluate(() => document.activeElement?.ariaLabel)])
    .toEqual(['35', 'Function 2, S2']);
  await expect.poll(() => app.undo.isDisabled()).toBe(true);
  await tap();
  /** What of the text is marked, or where the caret is. */
  const marked = () =>
    field.evaluate((input) => [(input as HTMLInputElement).selectionStart, (input as HTMLInputElement).selectionEnd]);
  await expect.poll(marked, { message: 'a second tap beside the text leaves it selected' }).toEqual([0, 2]);
});

/** The sizes of screens that are touched. */
const TOUCHED = [
  [390, 844],
  [360, 740],
  [320, 568],
  [844, 390],
  [820, 1180],
  [1180, 820],
  // A laptop at 200 %, and one with a touch screen.
  [640, 400],
  [1366, 650],
] as const;

test.each([
  ['a tablet with a keyboard', { width: 820, height: 1180 }],
  ['a laptop with a touch screen', { width: 1366, height: 650 }],
  ['a phone', { width: 390, height: 844 }],
])('on %s, the first tap after typing does what it is made on', async (_, viewport) => {
  const app = await AppPage.simulated({ viewport, hasTouch: true });
  await app.field('Function 2, S2').focus();
  await app.page.keyboard.press('Control+a');
  await app.page.keyboard.type('70');
  // What it does comes late on a slow machine: the keys would have come over it in the meantime.
  const { x, y } = await middleOf(app.button(/^Write 1 change…$/));
  await app.page.touchscreen.tap(x, y);
  await app.dialog.waitFor();
  expect(await app.field('Function 2, S2').inputValue()).toBe('70');
});

test('the keys on the touch screen do not cover the edited field or its row', async () => {
  /** What of a field and its row is not seen, and which keys do not fit. */
  const faults = (app: AppPage): Promise<string[]> =>
    app.page.evaluate(() => {
      const sheet = document.querySelector('.edit-sheet');
      const input = document.activeElement;
      const row = input?.closest('tr');
      if (!sheet || !row) return ['there is no sheet'];
      const box = sheet.getBoundingClientRect();
      const outside = box.left < 0 || box.top < 0 || box.right > innerWidth || box.bottom > innerHeight + 0.5;
      const covered = [...row.querySelectorAll('th, td')].filter((cell) => {
        const { left, top, width, height } = cell.getBoundingClientRect();
        const at = (y: number) => document.elementFromPoint(left + width / 2, y);
        return width > 0 && ![top + 2, top + height - 3].every((y) => at(y)?.closest('tr') === row);
      });
      const cut = [...sheet.querySelectorAll('button, output')].filter((key) => key.scrollWidth > key.clientWidth);
      return [
        ...(outside ? [`the sheet stands over the edge: ${JSON.stringify(box)}`] : []),
        ...covered.map((cell) => `covered: ${cell.textContent} ${cell.querySelector('input')?.ariaLabel}`),
        ...cut.map((key) => `cut: ${key.textContent}`),
      ];
    });

  const app = await AppPage.connected({ hasTouch: true });
  for (const [width, height] of TOUCHED) {
    await app.resize({ width, height });
    for (const theme of ['light', 'sun']) {
      const look = `${width} x ${height}, ${theme}`;
      await showTheme(app, theme);
      for (const field of [
        'Start, S1',
        en.program.motorStopTime,
        'Function 5, S2',
        'Function 9 time',
        'DT, S3',
        'DT time',
      ]) {
        await app.field(field).tap();
        await keysFor(app, field).waitFor();
        await expect
          .poll(() => faults(app), { message: `the keys cover the field ${field} or its row: ${look}` })
          .toEqual([]);
      }
      await app.button('+10 s').tap();
      await app.button('Put back').waitFor();
      await expect
        .poll(() => faults(app), { message: `the keys cover a field with its old value: ${look}` })
        .toEqual([]);
      await app.button('Put back').tap();
      await app.button('Done').tap();
      await expect.poll(() => app.page.locator('.edit-sheet').isVisible()).toBe(false);
    }
  }
});
