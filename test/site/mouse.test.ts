import { describe, expect, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { AppPage } from './app-page.js';
import { EDGE_ROUTES, ROUTES, textOf } from './mouse-routes.js';

/** The whole table is visible. */
const TALL = { viewport: { width: 1280, height: 1200 } };

async function opened(): Promise<AppPage> {
  const app = await AppPage.open({ bench: {}, isMoving: true, ...TALL });
  await app.connect();
  return app;
}

const cell = (app: AppPage, name: string) => app.table.getByRole('textbox', { name, exact: true });

describe('a drag with the mouse selects, and moves no value', () => {
  test('from anywhere to anywhere in the table', async () => {
    const app = await opened();
    const { mouse } = app.page;
    const toolbar = app.page.getByRole('toolbar', { name: en.edits.table.range.title });
    const before = await app.entries();
    for (const [from, to, selected] of [...ROUTES, ...EDGE_ROUTES]) {
      const what = `from ${from} to ${to}`;
      await cell(app, from).focus();
      await cell(app, from).selectText();
      const start = await textOf(cell(app, from));
      const end = await textOf(cell(app, to));
      for (const steps of [12, 2]) {
        await mouse.move(start.x, start.y);
        await mouse.down();
        await mouse.move(end.x, end.y, { steps });
        await mouse.up();
        await toolbar.getByText(selected, { exact: true }).waitFor();
        await expect.poll(() => app.entries(), { message: what }).toEqual(before);
        await mouse.move(start.x, start.y + 300);
        await app.page.getByText(selected, { exact: true }).waitFor();
      }
      await mouse.click(start.x, start.y);
      await toolbar.waitFor({ state: 'hidden' });
    }
    await app.text(/^As in the timer, (read|verified) \d\d:\d\d$/).waitFor();
  });

  test('and a click ends the selection', async () => {
    const app = await opened();
    const { mouse } = app.page;
    const start = await textOf(cell(app, 'Function 2, S1'));
    const end = await textOf(cell(app, 'Function 3, S1'));
    await mouse.move(start.x, start.y);
    await mouse.down();
    await mouse.move(end.x, end.y, { steps: 3 });
    await mouse.up();
    const toolbar = app.page.getByRole('toolbar', { name: en.edits.table.range.title });
    await toolbar.waitFor();
    await mouse.click(end.x, end.y);
    await toolbar.waitFor({ state: 'hidden' });
    await app.page.keyboard.press('Control+a');
    await app.page.keyboard.type('50');
    await expect.poll(() => app.valueOf('Function 3, S1')).toBe('50');
    await app.changes(1).waitFor();
  });

  test('also not a text from elsewhere', async () => {
    const app = await opened();
    const { mouse } = app.page;
    const before = await app.entries();
    const checks = app.page.getByRole('heading', { name: 'Checks' });
    await checks.evaluate((element) => getSelection()?.selectAllChildren(element));
    const heading = await checks.boundingBox();
    if (!heading) throw new Error('There is no heading.');
    const place = await textOf(cell(app, 'Function 2, S1'));
    await mouse.move(heading.x + 10, heading.y + heading.height / 2);
    await mouse.down();
    await mouse.move(place.x, place.y, { steps: 8 });
    await mouse.up();
    await expect.poll(() => app.entries()).toEqual(before);
    await app.text(/^As in the timer, (read|verified) \d\d:\d\d$/).waitFor();
  });
});

test('the wheel over the field that has the focus moves the page, and with Alt the value', async () => {
  const app = await AppPage.open({ bench: {}, viewport: { width: 1280, height: 520 } });
  await app.connect();
  const { mouse, keyboard } = app.page;
  const input = app.field('Function 2, S1');
  await input.focus();
  const place = await textOf(cell(app, 'Function 2, S1'));
  await mouse.move(place.x, place.y);
  const top = (): Promise<number> => app.page.evaluate(() => scrollY);
  const before = await top();
  await mouse.wheel(0, 200);
  await expect.poll(top).not.toBe(before);
  await expect.poll(() => app.valueOf('Function 2, S1')).toBe('35');
  await input.scrollIntoViewIfNeeded();
  const now = await textOf(cell(app, 'Function 2, S1'));
  await mouse.move(now.x, now.y);
  await keyboard.down('Alt');
  await mouse.wheel(0, -100);
  await keyboard.up('Alt');
  await expect.poll(() => app.valueOf('Function 2, S1')).toBe('36');
});
