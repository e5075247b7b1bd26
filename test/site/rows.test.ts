import { describe, expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
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

/**
 * How far the middles of the names lie below those of the figures of their rows, in pixels, and how many rows have a
 * height that is not a whole number: there the browser rounds names and figures to different lines.
 */
const unevenIn = (app: AppPage): Promise<{ below: number[]; broken: number }> =>
  app.page.evaluate(() => {
    const rows = [...document.querySelectorAll('.program-table tr[data-slot]:not(.motor-stop, .dt)')];
    const middle = ({ top, height }: DOMRect): number => top + height / 2;
    const below = rows.flatMap((row) => {
      const name = row.querySelector('th');
      const text = document.createRange();
      // On a phone the short name is not a text that can be measured.
      const word = name?.querySelector('.row-name')?.firstChild;
      if (!name || !word || getComputedStyle(name, '::before').content !== 'none') return [];
      text.selectNodeContents(word);
      const named = middle(text.getBoundingClientRect());
      return [...row.querySelectorAll('td input')].map((input) => named - middle(input.getBoundingClientRect()));
    });
    const heights = rows.map((row) => row.getBoundingClientRect().height);
    return { below, broken: heights.filter((height) => height % 1 !== 0).length };
  });

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
    const app = await AppPage.open({ bench: { granted: true }, ...options });
    await app.connect();
    const found = await rowsOf(app);
    expect(found.seen).toEqual(ALL);
    expect(found.least).toBeGreaterThanOrEqual(least);
    expect(found.scrolled).toBe(0);
    const uneven = await unevenIn(app);
    expect(uneven.broken).toBe(0);
    // The line of a field is rounded up, that of a name down, so a small difference is right.
    expect(Math.min(0, ...uneven.below)).toBeGreaterThan(-0.1);
    expect(Math.max(0, ...uneven.below)).toBeLessThan(0.7);
    await app.expectNoSidewaysScrolling();
  });
});

test.each([
  ['for an F1Q in the lowest window that shows it', 'Q', undefined],
  ['for an F1Q in the sun', 'Q', IN_SUN],
  ['for an F1B in the sun, which has a note more', 'B', IN_SUN],
] as const)('what stands below the table is whole %s', async (_, timerClass, before) => {
  const viewport = { width: 1280, height: 780 };
  const app = await AppPage.open({ bench: { granted: true, timerClass }, viewport, ...(before && { before }) });
  await app.connect();
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
  const app = await AppPage.open({ ...PHONE, viewport, bench: { granted: true } });
  await app.connect();
  await app.field('DT time').waitFor();
  await expect.poll(() => cutIn(app)).toEqual([]);
});

test.each([
  ['a phone', PHONE],
  ['a laptop', { viewport: { width: 1280, height: 800 } }],
])('on %s DT has its unit in minutes and none in seconds, changed or not', async (_, options) => {
  const app = await AppPage.open({ bench: { granted: true }, ...options });
  await app.connect();
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
  const app = await AppPage.open({ ...PHONE, viewport, bench: { granted: true } });
  await app.connect();
  await app.field('DT time').waitFor();
  await app.page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight));
  const seen = () =>
    app.table.locator('th.servo').evaluateAll((heads) =>
      heads.map((head) => {
        const { left, top, width, height } = head.getBoundingClientRect();
        return head.contains(document.elementFromPoint(left + width / 2, top + height / 2));
      }),
    );
  await expect.poll(() => app.page.evaluate(() => scrollY)).toBeGreaterThan(0);
  await expect.poll(seen).toEqual([true, true, true]);
});

describe('a timer of another layout', () => {
  test.each([
    ['a phone', PHONE],
    ['a laptop', { viewport: { width: 1280, height: 800 } }],
  ] as const)('can be scrolled on %s, and its heads and row names stay visible', async (_, options) => {
    const identity = { functions: 20, servos: 8 };
    const app = await AppPage.open({ bench: { granted: true, identity }, ...options });
    await app.connect();
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
    const unit = app.table.locator('tr.dt th .row-unit');
    // It stands beside the name, and the tools of the row do not cover it.
    await expect
      .poll(() =>
        unit.evaluate(
          (it) => (it.closest('th')?.getBoundingClientRect().right ?? 0) - it.getBoundingClientRect().right,
        ),
      )
      .toBeGreaterThan(8);
  });
});

test('20 functions show all three servos on a tablet in the sun', async () => {
  const app = await AppPage.open({
    ...touch,
    viewport: { width: 820, height: 1180 },
    bench: { granted: true, identity: { functions: 20 } },
    before: IN_SUN,
  });
  await app.connect();
  const hidden = () =>
    app.page.locator('.table-scroller').evaluate(({ scrollWidth, clientWidth }) => scrollWidth - clientWidth);
  await expect.poll(hidden).toBe(0);
});

test('on a phone on its side, a table that scrolls reaches down to the edge', async () => {
  const identity = { servos: 8 };
  const app = await AppPage.open({
    ...PHONE,
    viewport: { width: 844, height: 390 },
    bench: { granted: true, identity },
  });
  await app.connect();
  const below = () =>
    app.page.locator('.table-scroller').evaluate((table) => innerHeight - table.getBoundingClientRect().bottom);
  await expect.poll(async () => Math.abs(await below())).toBeLessThan(2);
});

test('on a phone the pilot switches between times and intervals, and the motor stop is always shown', async () => {
  const app = await AppPage.open({ bench: { granted: true }, ...PHONE });
  await app.connect();
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
