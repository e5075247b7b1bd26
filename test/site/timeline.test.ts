import type { Locator } from 'playwright';
import { describe, expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { type AppOptions, AppPage, middleOf } from './app-page.js';
import { fingerOn, PHONE } from './page.js';

const FIELD = 'Function 3 time';
/** In the name of a step. */
const MOVING = en.edits.steps.change({ what: 'function 3 time' });

interface Seen {
  readonly app: AppPage;
  readonly mark: Locator;
}

/** The mark of function 3, at 11.5 s between its neighbours at 11 s and at 12 s. */
async function opened(options: AppOptions = {}): Promise<Seen> {
  const app = await AppPage.connected(options);
  // On a phone the picture replaces the table.
  if (options.isMobile) await app.button('Picture').click();
  const mark = app.page.getByRole('group', { name: en.timeline.picture }).getByRole('slider', { name: FIELD });
  await mark.scrollIntoViewIfNeeded();
  return { app, mark };
}

const cell = (app: AppPage): Locator => app.table.getByRole('textbox', { name: FIELD, exact: true });

/** The picture may be drawn a moment after the table. @param time in seconds. */
const stands = (mark: Locator, time: number): Promise<void> =>
  expect.poll(() => mark.getAttribute('aria-valuenow')).toBe(String(time));

/**
 * Checks a moved mark: by whole steps of 0.1 s, in the table with the old value, and as one undo step.
 */
async function isMoved({ app, mark }: Seen): Promise<void> {
  const hundredths = Math.round(Number(await mark.getAttribute('aria-valuenow')) * 100);
  expect(hundredths).toBeGreaterThan(1150);
  expect(hundredths, 'the mark stays before its neighbour').toBeLessThan(1200);
  expect(hundredths % 10, `the time is no whole step of 0.1 s: ${hundredths} hundredths`).toBe(0);
  if (await app.button('Table').isVisible()) await app.button('Table').click();
  const value = (hundredths / 100).toFixed(2);
  await expect.poll(() => cell(app).inputValue()).toBe(value);
  await expect
    .poll(() => cell(app).getAttribute('aria-describedby'), { message: 'the old value is said with it' })
    .not.toBeNull();
  await app.table.getByText(en.knowledge.marks.now({ value: '11.5 s' })).waitFor();
  await app.changes(1).waitFor();
  await app.button(`Undo ${MOVING}`).click();
  await expect.poll(() => cell(app).inputValue()).toBe('11.50');
  await expect.poll(() => app.undo.isDisabled(), { message: 'the whole drag was one step of undo' }).toBe(true);
  await app.button(`Redo ${MOVING}`).click();
  await expect.poll(() => cell(app).inputValue()).toBe(value);
}

describe('the mark of a function is moved', () => {
  test('by mouse', async () => {
    const seen = await opened();
    const { mouse } = seen.app.page;
    const { x, y } = await middleOf(seen.mark);
    await mouse.move(x, y);
    await mouse.down();
    await mouse.move(x + 18, y, { steps: 6 });
    // The table follows during the drag.
    await expect.poll(() => cell(seen.app).inputValue()).not.toBe('11.50');
    await mouse.up();
    await isMoved(seen);
  });

  test('by mouse, many times, and no drawing but the last one is kept', async () => {
    const { app, mark } = await opened();
    const { mouse } = app.page;
    const { x, y } = await middleOf(mark);
    const devTools = await app.page.context().newCDPSession(app.page);
    await devTools.send('Performance.enable');
    const nodes = async (): Promise<number> => {
      await devTools.send('HeapProfiler.collectGarbage');
      const { metrics } = await devTools.send('Performance.getMetrics');
      return metrics.find(({ name }) => name === 'Nodes')?.value ?? 0;
    };
    const drag = async (): Promise<void> => {
      await mouse.move(x, y);
      await mouse.down();
      for (let way = 1; way <= 30; way++) await mouse.move(x + way, y);
      await mouse.move(x, y);
      await mouse.up();
      await stands(mark, 11.5);
    };
    await drag();
    const first = await nodes();
    for (let again = 0; again < 6; again++) await drag();
    expect(await nodes()).toBeLessThan(first + 40);
  });

  test('by finger, and the page stays where it is', async () => {
    const seen = await opened(PHONE);
    const { page } = seen.app;
    const { x, y } = await middleOf(seen.mark);
    const scrolled = (): Promise<number> => page.evaluate(() => scrollY);
    const before = await scrolled();
    const touch = await fingerOn(page);
    await touch('touchStart', { x, y });
    for (let way = 2; way <= 16; way += 2) await touch('touchMove', { x: x + way, y: y + way });
    await touch('touchEnd');
    expect(await scrolled()).toBe(before);
    await isMoved(seen);
  });
});
