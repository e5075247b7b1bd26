import { describe, expect, test } from 'vitest';
import { AppPage, FIRST_POSITIONS } from './app-page.js';
import { PHONE } from './page.js';
import { positionField, ROWS, SHEET, SHIFTED, Trail, timeField } from './sheet.js';
import { isWellMade, SIZES } from './well-made.js';

test('by thumb alone: a whole program from a sheet, shifted, undone to the start, redone, written, verified', async () => {
  const app = await AppPage.open({ bench: {}, ...PHONE });
  expect(await app.page.evaluate(() => matchMedia('(hover: none) and (pointer: coarse)').matches)).toBe(true);
  await app.button('Connect').tap();
  await app.hasRead();
  const trail = new Trail(app);
  const fill = async (field: string, text: string): Promise<void> => {
    await app.field(field).tap();
    await trail.note();
    // What the thumb types on: an empty hint would bring up a keyboard of letters.
    expect(await app.field(field).getAttribute('inputmode')).toMatch(/^(decimal|numeric)$/);
    await app.page.keyboard.type(text);
  };
  /** Taps that follow each other at one field are one step to undo. */
  const tap = async (...names: string[]): Promise<void> => {
    await trail.note();
    for (const name of names) await app.button(name).tap();
  };

  await fill('Motor stop', '7.8');
  await tap('Step up Motor stop', 'Step up Motor stop');
  for (const [row, time] of SHEET.times.entries()) {
    if (row > 0 && row < SHEET.times.length - 1) await fill(timeField(row), time);
  }
  await tap('DT 4 min');
  for (const [servo, positions] of SHEET.positions.entries()) {
    for (const row of ROWS.keys()) {
      const field = positionField(row, servo);
      await fill(field, field === 'DT, S3' ? '21' : (positions[row] ?? ''));
    }
  }
  // To the 20 of the sheet.
  await tap('Step down DT, S3', 'Step down DT, S3', 'Step up DT, S3');
  expect(await app.page.evaluate(() => document.activeElement?.ariaLabel), 'the keys stay').toBe('DT, S3');

  // A tap beside the fields puts the step keys away, which lie over what follows.
  await app.page.getByRole('heading', { name: 'Checks' }).tap();
  await app.button('Tools for Function 4').tap();
  await app.page.getByRole('textbox', { name: 'By, in seconds' }).fill('1.5');
  await tap('Later');
  await trail.note();
  await app.button('Done').tap();

  await trail.goBack(() => app.undo.tap());
  await app.text(/^As in the timer, (read|verified) \d\d:\d\d$/).waitFor();
  await trail.goForward(() => app.redo.tap());
  await app.text('44 changes').waitFor();

  await app.button(/^Write( \d+)?…$/).tap();
  await app.dialog.getByRole('checkbox', { name: 'The propeller is off' }).tap();
  await app.dialog.getByRole('button', { name: 'Write 44 changes' }).tap();
  await app.result('Verified.');
  await app.dialog.getByRole('button', { name: 'Close' }).tap();
  await app.dialog.waitFor({ state: 'hidden' });
  await app.text(/^As in the timer, (read|verified) \d\d:\d\d$/).waitFor();
  expect(await app.bench(({ content }) => content)).toEqual(SHIFTED);
});

describe('a finger on the table', () => {
  interface Hand {
    readonly app: AppPage;
    /** How far down on the screen a field is: where the page was scrolled to, whatever grew above it. */
    readonly topOf: (field: string) => Promise<number>;
    /** Draws over a field, from its middle so far to the right and down, in small movements. */
    readonly draw: (field: string, right: number, down: number) => Promise<void>;
    /** Taps wherever the field is, whether it takes the focus or not. */
    readonly tap: (field: string) => Promise<void>;
    /** What of the text is marked, or where the caret is. */
    readonly marked: (field: string) => Promise<(number | null)[]>;
    readonly focused: () => Promise<string | null | undefined>;
  }

  async function opened(): Promise<Hand> {
    const app = await AppPage.open({ bench: {}, ...PHONE, permissions: ['clipboard-read', 'clipboard-write'] });
    await app.button('Connect').tap();
    await app.hasRead();
    const { page } = app;
    const devTools = await page.context().newCDPSession(page);
    const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', ...touchPoints: { x: number; y: number }[]) =>
      devTools.send('Input.dispatchTouchEvent', { type, touchPoints });
    const middleOf = async (field: string): Promise<{ x: number; y: number }> => {
      await app.field(field).scrollIntoViewIfNeeded();
      const box = await app.field(field).boundingBox();
      if (!box) throw new Error(`${field} is not in sight`);
      return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
    };
    return {
      app,
      topOf: (field) => app.field(field).evaluate((input) => input.getBoundingClientRect().top),
      draw: async (field, right, down) => {
        const { x, y } = await middleOf(field);
        const way = Math.max(Math.abs(right), Math.abs(down));
        await touch('touchStart', { x, y });
        for (let gone = 2; gone <= way; gone += 2) {
          await touch('touchMove', { x: x + (right * gone) / way, y: y + (down * gone) / way });
        }
        await touch('touchEnd');
      },
      tap: async (field) => {
        const { x, y } = await middleOf(field);
        await page.touchscreen.tap(x, y);
      },
      marked: (field) =>
        app
          .field(field)
          .evaluate((input) => [(input as HTMLInputElement).selectionStart, (input as HTMLInputElement).selectionEnd]),
      focused: () => page.evaluate(() => document.activeElement?.ariaLabel),
    };
  }

  test('that swipes steps the field that has the focus, and that is one step to undo', async () => {
    const { app, draw, tap, marked, topOf } = await opened();
    await draw('Function 2, S2', 60, 0);
    expect(await app.undo.isDisabled(), 'nothing without the focus').toBe(true);

    await tap('Function 2, S2');
    const before = await topOf('Function 2, S2');
    await draw('Function 2, S2', 60, 40);
    expect(await app.valueOf('Function 2, S2')).toBe('39');
    expect(await marked('Function 2, S2'), 'all of it, as before').toEqual([0, 2]);
    // The row has got a button: that may take a few pixels.
    expect(Math.abs((await topOf('Function 2, S2')) - before), 'nothing scrolls').toBeLessThan(10);
    await app.button('Undo stepping Function 2, S2').tap();
    expect(await app.valueOf('Function 2, S2')).toBe('35');
    expect(await app.undo.isDisabled()).toBe(true);

    await tap('DT');
    await draw('DT', -60, 0);
    expect(await app.valueOf('DT')).toBe('2:56');
  });

  test('that goes up over the field with the focus scrolls the page, and changes nothing', async () => {
    const { app, draw, tap, marked, topOf, focused } = await opened();
    await tap('Function 2, S2');
    const before = await topOf('Function 2, S2');
    await draw('Function 2, S2', 30, -200);
    await expect.poll(() => topOf('Function 2, S2')).toBeLessThan(before - 100);
    expect([await app.valueOf('Function 2, S2'), await focused()]).toEqual(['35', 'Function 2, S2']);
    expect(await app.undo.isDisabled()).toBe(true);
    await tap('Function 2, S2');
    const [start, end] = await marked('Function 2, S2');
    expect(start, 'a tap puts the caret').toBe(end);
  });

  test('selects a range, copies it, fills it down and pastes it', async () => {
    const { app, tap, focused } = await opened();
    await tap('Function 1, S1');
    await app.button('Select range').tap();
    await app.page.getByRole('toolbar', { name: 'Selected range' }).getByText('Now tap another cell.').waitFor();
    await tap('Function 3, S2');
    await app.text('3 functions, 2 columns').waitFor();
    expect(await focused(), 'no keyboard comes up').toBeFalsy();
    await isWellMade(app, 'a range', { phone: SIZES.phone });
    await app.button('Copy').tap();
    await app.page.getByText('Copied.', { exact: true }).waitFor();
    expect(await app.page.evaluate(() => navigator.clipboard.readText())).toBe('25\t25\n35\t35\n45\t45');
    await app.button('Fill down').tap();
    expect((await app.positions('S2')).slice(0, 5)).toEqual(['15', '25', '25', '25', '55']);
    await app.button('Done').tap();
    await app.button('Undo fill down of 4 values').tap();
    expect(await app.positions('S2')).toEqual(FIRST_POSITIONS);

    await tap('Function 5, S2');
    await isWellMade(app, 'a field with the focus', { phone: SIZES.phone });
    await app.button('Select range').tap();
    await app.button('Paste…').tap();
    await app.page.getByRole('dialog', { name: 'Paste' }).getByRole('button', { name: 'Paste' }).tap();
    expect((await app.positions('S3')).slice(5, 9)).toEqual(['25', '35', '45', '95']);
  });
});
