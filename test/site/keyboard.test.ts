import { expect, test } from 'vitest';
import { AppPage } from './app-page.js';
import { Keys } from './keys.js';
import { positionField, ROWS, SHEET, SHIFTED, Trail, timeField } from './sheet.js';

test('by keyboard alone: a whole program from a sheet, shifted, undone to the start, redone, written, verified', async () => {
  const app = await AppPage.open({ bench: {} });
  const keys = new Keys(app.page);
  await keys.enter(/^Connect$/);
  await app.hasRead();
  const trail = new Trail(app);
  const fill = async (field: string, text: string): Promise<void> => {
    await expect.poll(() => keys.focused()).toBe(field);
    await trail.note();
    await keys.type(text);
  };

  // Down the times, up the first servo, down the second, up the third, without leaving the table.
  await keys.tabTo(/^Motor stop time$/);
  for (const [row, time] of SHEET.times.entries()) {
    if (row > 0) await keys.press('Enter');
    await fill(timeField(row), time);
  }
  await keys.press('ArrowRight');
  for (const [servo, positions] of SHEET.positions.entries()) {
    await keys.press('ArrowRight');
    const rows = [...ROWS.keys()];
    if (servo % 2 === 0) rows.reverse();
    for (const [at, row] of rows.entries()) {
      if (at > 0) await keys.press(servo % 2 === 0 ? 'Shift+Enter' : 'Enter');
      await fill(positionField(row, servo), positions[row] ?? '');
    }
  }

  // The tools of a row are left of its time. What is typed there replaces the old text.
  await keys.tabTo(/^Function 4 time$/);
  await keys.press('ArrowLeft');
  await keys.press('Enter');
  await expect.poll(() => keys.focused()).toMatch(/^By, in seconds/);
  await keys.type('1.5');
  await trail.note();
  await keys.press('Enter');
  await trail.note();
  await keys.press('Escape');
  await expect.poll(() => keys.focused()).toBe('Tools for Function 4');

  await trail.goBack(() => keys.press('Control+z'));
  await app.text(/^As in the timer, (read|verified) \d\d:\d\d$/).waitFor();
  await trail.goForward(() => keys.press('Control+Shift+z'));
  await app.changes(44).waitFor();

  await keys.enter(/^Write \d+ changes?…$/);
  await app.dialog.waitFor();
  await expect
    .poll(() => app.dialog.locator('.differs').count(), { message: 'the dialog shows 44 different values' })
    .toBe(44);
  await keys.tabTo(/^The propeller is off/);
  await keys.press('Space');
  await keys.enter(/^Write 44 changes$/);
  await app.result('Verified.');
  await keys.enter(/^Close$/);
  await app.dialog.waitFor({ state: 'hidden' });
  await app.text(/^As in the timer, (read|verified) \d\d:\d\d$/).waitFor();
  expect(await app.bench(({ content }) => content)).toEqual(SHIFTED);
});

test('the focus stays during a reading, and comes back after the dialog', async () => {
  const app = await AppPage.open({ bench: { granted: true } });
  const keys = new Keys(app.page);
  await app.connect();
  await keys.enter(/^Read again$/);
  await app.isReady();
  await expect.poll(() => keys.focused()).toBe('Read again');
  await app.field('Function 2, S1').fill('7');
  await keys.enter(/^Write \d+ changes?…$/);
  await app.dialog.waitFor();
  await keys.press('Escape');
  await app.dialog.waitFor({ state: 'hidden' });
  await expect.poll(() => keys.focused()).toBe('Write 1 change…');
  await keys.press('Enter');
  await app.dialog.waitFor();
  await keys.tabTo(/^The propeller is off/);
  await keys.press('Space');
  await keys.enter(/^Write 1 change$/);
  await app.result('Verified.');
  await keys.enter(/^Close$/);
  await app.dialog.waitFor({ state: 'hidden' });
  await expect.poll(() => keys.focused()).toBe('Write…');
});

test('in a narrow window the arrow keys walk through the memories; a click goes to one', async () => {
  const app = await AppPage.open({ bench: { granted: true }, viewport: { width: 390, height: 844 } });
  const keys = new Keys(app.page);
  await app.connect();
  await keys.enter(/^M1, flies next.*Memories and more/);
  await keys.tabTo(/^M1, flies next$/);
  for (const [key, memory] of [
    ['ArrowRight', 'M2'],
    ['ArrowRight', 'M3'],
    ['ArrowLeft', 'M2'],
    ['ArrowDown', 'M3'],
  ] as const) {
    await keys.press(key);
    await app.page.getByRole('heading', { name: new RegExp(`^${memory}`) }).waitFor({ state: 'attached' });
    await expect.poll(() => keys.focused()).toBe(memory);
  }
  const panel = app.page.locator('.strip-panel');
  await keys.press('Escape');
  await panel.waitFor({ state: 'detached' });
  await app.lookAt('M2');
  await panel.waitFor({ state: 'detached' });
});
