import { describe, expect, test } from 'vitest';
import { AppPage } from './app-page.js';
import { PHONE } from './page.js';

/** What of the table is in sight between the strip and what stays at the lower edge, before anything is scrolled. */
async function rowsOf(app: AppPage): Promise<{ seen: string[]; least: number; scrolled: number }> {
  return app.page.evaluate(() => {
    const edge = (selector: string, side: 'top' | 'bottom', otherwise: number): number =>
      document.querySelector(selector)?.getBoundingClientRect()[side] ?? otherwise;
    const top = edge('.top', 'bottom', 0);
    const bottom = Math.min(edge('.actions', 'top', innerHeight), innerHeight);
    const rows = [...document.querySelectorAll<HTMLElement>('.program-table tr[data-slot]')];
    const boxes = rows.map((row) => ({ row, box: row.getBoundingClientRect() }));
    // Half a pixel: a share of the height is seldom a whole number.
    const isSeen = ({ box }: { box: DOMRect }) => box.top >= top - 0.5 && box.bottom <= bottom + 0.5;
    return {
      seen: boxes.filter(isSeen).map(({ row }) => row.querySelector('.row-name')?.textContent ?? ''),
      least: Math.min(...boxes.filter(({ row }) => !row.matches('.motor-stop')).map(({ box }) => box.height)),
      scrolled: scrollY,
    };
  });
}

const FUNCTIONS = Array.from({ length: 9 }, (_, at) => `Function ${at + 1}`);
const ALL = ['Start', 'Motor stop', ...FUNCTIONS, 'DT'];
const touch = { hasTouch: true, isMobile: true };

describe('all of a usual timer is in sight, with no row too low', () => {
  test.each([
    ['a small phone', { ...PHONE, viewport: { width: 360, height: 740 } }, 44],
    ['a phone', PHONE, 44],
    ['a small laptop', { viewport: { width: 1280, height: 800 } }, 36],
    ['the window of a laptop', { viewport: { width: 1366, height: 650 } }, 36],
    ['a laptop', { viewport: { width: 1440, height: 900 } }, 36],
    ['a tablet', { ...touch, viewport: { width: 820, height: 1180 } }, 48],
  ] as const)('on %s', async (_, options, least) => {
    const app = await AppPage.open({ bench: { granted: true }, ...options });
    await app.connect();
    const found = await rowsOf(app);
    expect(found.seen).toEqual(ALL);
    expect(found.least).toBeGreaterThanOrEqual(least);
    expect(found.scrolled).toBe(0);
    await app.expectNoSidewaysScrolling();
  });
});

describe('a timer of another layout', () => {
  test.each([
    ['a phone', PHONE],
    ['a laptop', { viewport: { width: 1280, height: 800 } }],
  ] as const)('is looked at in a part on %s, its heads and the names of its rows in sight', async (_, options) => {
    const identity = { functions: 20, servos: 8 };
    const app = await AppPage.open({ bench: { granted: true, identity }, ...options });
    await app.connect();
    await app.expectNoSidewaysScrolling();
    const last = app.table.getByRole('textbox', { name: 'DT, S8', exact: true });
    await last.focus();
    const seen = await last.evaluate((input) => {
      const isSeen = (element: Element | null | undefined): boolean => {
        const { left, top, width, height } = element?.getBoundingClientRect() ?? new DOMRect();
        const there = document.elementFromPoint(left + Math.min(width, 60) / 2, top + height / 2);
        return element?.contains(there) ?? false;
      };
      const table = input.closest('table');
      return [input, table?.querySelector('th.servo:last-child'), input.closest('tr')?.querySelector('th')].map(isSeen);
    });
    expect(seen).toEqual([true, true, true]);
  });
});

test('on a phone the times give way to the intervals, and come back, with the motor stop always there', async () => {
  const app = await AppPage.open({ bench: { granted: true }, ...PHONE });
  await app.connect();
  const time = app.field('Function 2 time');
  const interval = app.field('Function 2 interval');
  await expect.poll(async () => [await time.isVisible(), await interval.isVisible()]).toEqual([true, false]);
  await app.button('Show intervals').tap();
  await interval.waitFor();
  await expect
    .poll(async () => [await time.isVisible(), await app.field('Motor stop time').isVisible()])
    .toEqual([false, true]);
  await app.button('Show times').tap();
  await time.waitFor();
  await expect.poll(() => interval.isVisible()).toBe(false);
});
