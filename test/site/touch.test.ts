import { expect, test } from 'vitest';
import { AppPage } from './app-page.js';
import { PHONE } from './page.js';
import { positionField, ROWS, SHEET, SHIFTED, Trail, timeField } from './sheet.js';

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
  await tap('DT 4:00');
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
  await app.text('Shift in time').tap();
  // The list of choices is the browser's own.
  await app.page.getByRole('combobox', { name: 'This and all later, from' }).selectOption('Function 4');
  await app.page.getByRole('textbox', { name: 'By, in seconds' }).tap();
  for (let i = 0; i < 4; i++) await app.page.keyboard.press('Backspace');
  await app.page.keyboard.type('1.5');
  await tap('Later');
  await trail.note();

  await trail.goBack(() => app.undo.tap());
  await app.text('No changes').waitFor();
  await trail.goForward(() => app.redo.tap());
  await app.text('44 changes').waitFor();

  await app.button('Write…').tap();
  await app.dialog.getByRole('checkbox', { name: 'The propeller is off' }).tap();
  await app.dialog.getByRole('button', { name: 'Write 44 changes' }).tap();
  await app.result('Verified.');
  await app.dialog.getByRole('button', { name: 'Close' }).tap();
  await app.dialog.waitFor({ state: 'hidden' });
  await app.text('No changes').waitFor();
  expect(await app.bench(({ content }) => content)).toEqual(SHIFTED);
}, 120_000);
