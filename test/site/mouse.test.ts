import { describe, expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage, edgesOf } from './app-page.js';
import { EDGE_ROUTES, ROUTES, textOf } from './mouse-routes.js';

/** The whole table is visible. */
const TALL = { viewport: { width: 1280, height: 1200 } };

async function opened(): Promise<AppPage> {
  const app = await AppPage.connected({ isMoving: true, ...TALL });
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

  test('also not a text from elsewhere', async () => {
    const app = await opened();
    const { mouse } = app.page;
    const before = await app.entries();
    const checks = app.page.getByRole('heading', { name: 'Checks' });
    await checks.evaluate((element) => getSelection()?.selectAllChildren(element));
    const heading = await edgesOf(checks);
    const place = await textOf(cell(app, 'Function 2, S1'));
    await mouse.move(heading.left + 10, (heading.top + heading.bottom) / 2);
    await mouse.down();
    await mouse.move(place.x, place.y, { steps: 8 });
    await mouse.up();
    await expect.poll(() => app.entries()).toEqual(before);
    await app.text(/^As in the timer, (read|verified) \d\d:\d\d$/).waitFor();
  });
});

test.each([
  ['before', 0.1],
  ['behind', 0.95],
])('after a second click %s a text, what is typed replaces it', async (_, share) => {
  const app = await opened();
  const dt = cell(app, 'DT time');
  const { width, height } = await edgesOf(dt);
  for (let i = 0; i < 2; i++) await dt.click({ position: { x: width * share, y: height / 2 } });
  await expect
    .poll(() => dt.evaluate(({ selectionStart: from, selectionEnd: to }: HTMLInputElement) => [from, to]))
    .toEqual([0, 4]);
  await app.page.keyboard.type('2.30');
  expect(await app.valueOf('DT time')).toBe('2.30');
});
