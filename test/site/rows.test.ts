import type { Locator } from 'playwright';
import { describe, expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage, edgesOf, hiddenOf, isInSight } from './app-page.js';
import { IN_SUN, PHONE } from './page.js';

/** The visible part of the table between the strip and the bar at the lower edge, before scrolling. */
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

describe('a usual timer is fully visible, and no row is too low', () => {
  test.each([
    ['a small phone', { ...PHONE, viewport: { width: 360, height: 740 } }, 44],
    ['a phone', PHONE, 44],
    ['a small laptop', { viewport: { width: 1280, height: 800 } }, 36],
    ['the window of a laptop', { viewport: { width: 1366, height: 650 } }, 36],
    ['a laptop', { viewport: { width: 1440, height: 900 } }, 36],
    ['a tablet', { ...touch, viewport: { width: 820, height: 1180 } }, 48],
  ] as const)('on %s', async (_, options, least) => {
    const app = await AppPage.connected(options);
    const found = await rowsOf(app);
    expect(found.seen).toEqual(ALL);
    expect(found.least).toBeGreaterThanOrEqual(least);
    expect(found.scrolled).toBe(0);
    await app.expectNoSidewaysScrolling();
  });
});

test.each([
  ['for an F1Q in the lowest window that shows it', 'Q', undefined],
  ['for an F1Q in the sun', 'Q', IN_SUN],
  ['for an F1B in the sun, which has a note more', 'B', IN_SUN],
] as const)('what stands below the table is whole %s', async (_, timerClass, before) => {
  const viewport = { width: 1280, height: 780 };
  const app = await AppPage.connected({ bench: { timerClass }, viewport, ...(before && { before }) });
  const cut = () =>
    app.page.evaluate(() => {
      const bar = document.querySelector('.actions')?.getBoundingClientRect().top ?? 0;
      const hints = [...document.querySelectorAll('.program-main .hint')];
      return hints.filter((hint) => hint.getBoundingClientRect().bottom > bar).map(({ textContent }) => textContent);
    });
  await expect.poll(cut).toEqual([]);
});

/** The rows that the lower edge cuts, with how many pixels of each are in sight. */
const cutIn = (app: AppPage): Promise<string[]> =>
  app.page.evaluate(() => {
    const bar = document.querySelector('.actions')?.getBoundingClientRect();
    // On a phone on its side it stands beside the table, in its whole height.
    const edge = bar && bar.top > innerHeight / 2 ? bar.top : innerHeight;
    const rows = [...document.querySelectorAll('.program-table tr')];
    return rows
      .map((row) => ({ row, box: row.getBoundingClientRect() }))
      .filter(({ box }) => box.top < edge - 0.5 && box.bottom > edge + 1.5)
      .map(({ row, box }) => `${row.querySelector('th')?.textContent}: ${edge - box.top} of ${box.height}`);
  });

test.each([
  ['a small phone', { width: 360, height: 740 }],
  ['a phone', { width: 390, height: 844 }],
  ['a phone on its side', { width: 844, height: 390 }],
])('no row begins at the lower edge of %s that nobody can read', async (_, viewport) => {
  const app = await AppPage.connected({ ...PHONE, viewport });
  await app.field('DT time').waitFor();
  await expect.poll(() => cutIn(app)).toEqual([]);
});

test.each([
  ['a phone', PHONE],
  ['a laptop', { viewport: { width: 1280, height: 800 } }],
])('on %s DT has its unit in minutes and none in seconds, changed or not', async (_, options) => {
  const app = await AppPage.connected(options);
  const name = app.table.locator('tr.dt th');
  await name.getByText('min').waitFor();
  await app.type('DT time', '6:00');
  await name.getByText('min').waitFor();
  await app.type('DT time', '20 s');
  await name.getByText('min').waitFor({ state: 'detached' });
  await app.type('Function 9 time', '1:05');
  const covered = app.table.locator('.row-unit').evaluate((unit) => {
    const opener = unit.closest('th')?.querySelector('.row-opener') as Element;
    const { right, width } = getComputedStyle(opener, '::after');
    const from = opener.getBoundingClientRect().right - Number.parseFloat(right) - Number.parseFloat(width);
    return Math.max(0, unit.getBoundingClientRect().right - from);
  });
  expect(await covered, 'the sign of the tools stands beside it').toBe(0);
});

test.each([
  ['a small phone', { width: 360, height: 640 }],
  ['a phone on its side', { width: 844, height: 390 }],
])('the heads of the columns stay in sight on %s', async (_, viewport) => {
  const app = await AppPage.connected({ ...PHONE, viewport });
  await app.field('DT time').waitFor();
  await app.page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight));
  await expect.poll(() => app.page.evaluate(() => scrollY)).toBeGreaterThan(0);
  for (const head of await app.table.locator('th.servo').all()) await expect.poll(() => isInSight(head)).toBe(true);
});

describe('a timer of another layout', () => {
  test.each([
    ['a phone', PHONE],
    ['a laptop', { viewport: { width: 1280, height: 800 } }],
  ] as const)('can be scrolled on %s, and its heads and row names stay visible', async (_, options) => {
    const identity = { functions: 20, servos: 8 };
    const app = await AppPage.connected({ bench: { identity }, ...options });
    await app.expectNoSidewaysScrolling();
    const below = () =>
      app.page.evaluate(() => document.documentElement.scrollHeight - document.documentElement.clientHeight);
    expect(await below(), 'only the table scrolls, not the page').toBe(0);
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
    // The unit stands beside the name, and the tools of the row do not cover it.
    const [name, unit] = ['th', 'th .row-unit'].map((part) => app.table.locator(`tr.dt ${part}`)) as [Locator, Locator];
    await expect.poll(async () => (await edgesOf(name)).right - (await edgesOf(unit)).right).toBeGreaterThan(8);
  });
});

test('20 functions show all three servos on a tablet in the sun', async () => {
  const app = await AppPage.connected({
    ...touch,
    viewport: { width: 820, height: 1180 },
    bench: { identity: { functions: 20 } },
    before: IN_SUN,
  });
  await expect.poll(() => hiddenOf(app.page.locator('.table-scroller'))).toBe(0);
});

test('on a phone on its side, a table that scrolls reaches down to the edge', async () => {
  const viewport = { width: 844, height: 390 };
  const app = await AppPage.connected({ ...PHONE, viewport, bench: { identity: { servos: 8 } } });
  const scroller = app.page.locator('.table-scroller');
  await expect.poll(async () => Math.abs(viewport.height - (await edgesOf(scroller)).bottom)).toBeLessThan(2);
});

test('on a phone the pilot switches between times and intervals, and the motor stop is always shown', async () => {
  const app = await AppPage.connected(PHONE);
  const time = app.field('Function 2 time');
  const interval = app.field('Function 2 interval');
  await expect.poll(async () => [await time.isVisible(), await interval.isVisible()]).toEqual([true, false]);
  await app.button(en.edits.table.switch).tap();
  await interval.waitFor();
  await expect
    .poll(async () => [await time.isVisible(), await app.field(en.program.motorStopTime).isVisible()])
    .toEqual([false, true]);
  await app.button(en.edits.table.switch).tap();
  await time.waitFor();
  await expect.poll(() => interval.isVisible()).toBe(false);
});
