import type { Locator } from 'playwright';
import { describe, expect, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { AppPage, FIRST_POSITIONS } from './app-page.js';
import { PHONE } from './page.js';
import { positionField, ROWS, SHEET, SHIFTED, Trail, timeField } from './sheet.js';
import { showTheme } from './themes.js';

/** The sheet of keys that opens for a field. */
const keysFor = (app: AppPage, field: string): Locator =>
  app.page.getByRole('region', { name: `Keys for ${field}`, exact: true });

test('by thumb alone: a whole program from a sheet, shifted, undone to the start, redone, written, verified', async () => {
  const app = await AppPage.open({ bench: {}, isMoving: true, ...PHONE });
  expect(await app.page.evaluate(() => matchMedia('(hover: none) and (pointer: coarse)').matches)).toBe(true);
  await app.button('Connect').tap();
  await app.hasRead();
  const trail = new Trail(app);
  /** Presses keys of the sheet, one after the other. Everything done at one field is one undo step. */
  const press = async (field: string, keys: readonly string[]): Promise<void> => {
    await trail.note();
    const [first = '', ...rest] = keys;
    // The sheet may still be opening; after that its keys do not move.
    await keysFor(app, field).getByRole('button', { name: first, exact: true }).tap();
    for (const name of rest) {
      const box = await keysFor(app, field).getByRole('button', { name, exact: true }).boundingBox();
      if (!box) throw new Error(`${field} has no key ${name}`);
      await app.page.touchscreen.tap(box.x + box.width / 2, box.y + box.height / 2);
    }
  };
  const write = (field: string, text: string): Promise<void> => press(field, [...text.replace(',', '.')]);
  const go = (from: string, to: string): Promise<void> =>
    keysFor(app, from)
      .getByRole('button', { name: `Go to ${to} ›`, exact: true })
      .tap();

  await app.field(en.program.motorStopTime).tap();
  // The keyboard of the system does not open as well.
  await expect.poll(() => app.field(en.program.motorStopTime).getAttribute('inputmode')).toBe('none');
  await write(en.program.motorStopTime, '7.8');
  await press(en.program.motorStopTime, ['+0.1 s', '+0.1 s']);
  for (const row of ROWS.keys()) {
    const isFunction = row > 0 && row < ROWS.length - 1;
    await app.field(isFunction ? timeField(row) : positionField(row, 0)).tap();
    if (isFunction) await write(timeField(row), SHEET.times[row] ?? '');
    if (isFunction) await go(timeField(row), 'S1');
    for (const [servo, positions] of SHEET.positions.entries()) {
      const field = positionField(row, servo);
      if (servo > 0) await go(positionField(row, servo - 1), `S${servo + 1}`);
      await write(field, field === 'DT, S3' ? '21' : (positions[row] ?? ''));
    }
  }
  // To the 20 of the sheet.
  await press('DT, S3', ['−1', '−1', '+1']);
  expect(
    await app.page.evaluate(() => document.activeElement?.ariaLabel),
    'the field keeps the focus, so the keys stay',
  ).toBe('DT, S3');
  await keysFor(app, 'DT, S3').getByRole('button', { name: 'Done' }).tap();
  await trail.note();
  await app.page.locator('.strip-figures').tap();
  await app.button('DT 4 min').tap();
  await app.page.locator('.strip-close').tap();

  await app.button('Tools for Function 4').tap();
  await app.page.getByRole('textbox', { name: en.edits.shift.by }).fill('1.5');
  await trail.note();
  await app.button('Later').tap();
  await trail.note();
  await app.button('Done').tap();

  await trail.goBack(() => app.undo.tap());
  await app.text(/^As in the timer, (read|verified) \d\d:\d\d$/).waitFor();
  await trail.goForward(() => app.redo.tap());
  await app.changes(44).waitFor();

  await app.button(/^Write( \d+ changes?)?…$/).tap();
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

  test('that moves up over the field with the focus scrolls the page, and changes nothing', async () => {
    const { app, draw, tap, marked, topOf, focused } = await opened();
    await tap('Function 2, S2');
    const before = await topOf('Function 2, S2');
    await draw('Function 2, S2', 30, -200);
    await expect.poll(() => topOf('Function 2, S2')).toBeLessThan(before - 100);
    await expect
      .poll(async () => [await app.valueOf('Function 2, S2'), await focused()])
      .toEqual(['35', 'Function 2, S2']);
    await expect.poll(() => app.undo.isDisabled()).toBe(true);
    await tap('Function 2, S2');
    await expect
      .poll(() => marked('Function 2, S2'), { message: 'a second tap beside the text leaves it selected' })
      .toEqual([0, 2]);
  });

  test('selects a range, copies it, fills it down and pastes it', async () => {
    const { app, tap, focused } = await opened();
    await tap('Function 1, S1');
    await app.button(en.edits.sheet.selectRange).tap();
    await app.page
      .getByRole('toolbar', { name: en.edits.table.range.title })
      .getByText(en.edits.table.range.pick)
      .waitFor();
    await tap('Function 3, S2');
    await app.text('3 functions, 2 columns').waitFor();
    expect(await focused(), 'no field has the focus, so no keyboard comes up').toBeFalsy();
    await app.button('Copy').tap();
    await app.page.getByText('Copied.', { exact: true }).waitFor();
    expect(await app.page.evaluate(() => navigator.clipboard.readText())).toBe('25\t25\n35\t35\n45\t45');
    await app.button('Fill down').tap();
    await expect.poll(async () => (await app.positions('S2')).slice(0, 5)).toEqual(['15', '25', '25', '25', '55']);
    await app.button('Done').tap();
    await app.button('Undo fill down of 4 values').tap();
    await expect.poll(() => app.positions('S2')).toEqual(FIRST_POSITIONS);

    await tap('Function 5, S2');
    await app.button(en.edits.sheet.selectRange).tap();
    await app.button('Paste…').tap();
    await app.page.getByRole('dialog', { name: 'Paste' }).getByRole('button', { name: 'Paste' }).tap();
    await expect.poll(async () => (await app.positions('S3')).slice(5, 9)).toEqual(['25', '35', '45', '95']);
  });
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
  const app = await AppPage.open({ viewport, hasTouch: true });
  await app.trySimulated('F1Q');
  await app.field('Function 2, S2').focus();
  await app.page.keyboard.press('Control+a');
  await app.page.keyboard.type('70');
  // What it does comes late on a slow machine: the keys would have come over it in the meantime.
  const box = await app.button(/^Write 1 change…$/).boundingBox();
  await app.page.touchscreen.tap((box?.x ?? 0) + (box?.width ?? 0) / 2, (box?.y ?? 0) + (box?.height ?? 0) / 2);
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

  const app = await AppPage.open({ bench: { granted: true }, hasTouch: true });
  await app.connect();
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
