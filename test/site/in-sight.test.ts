import type { Locator } from 'playwright';
import { expect, test } from 'vitest';
import { AppPage } from './app-page.js';
import { PHONE } from './page.js';

/** A laptop at 200 %. */
const LOW = { width: 640, height: 400 };

test('the field with the focus, and the end of a range, are never behind what stays at the edges', async () => {
  const app = await AppPage.open({ bench: { granted: true }, viewport: LOW });
  await app.connect();
  /** What of these cells is seen in the middle of each: the cell, or what covers it. */
  const seen = (cells: string) =>
    app.page.evaluate((selector) => {
      const found = [...document.querySelectorAll(selector)];
      return found.map((cell) => {
        const { left, top, width, height } = cell.getBoundingClientRect();
        const there = document.elementFromPoint(left + width / 2, top + height / 2);
        return there && cell.contains(there) ? 'seen' : `${cell.getAttribute('aria-label')} at ${top}`;
      });
    }, cells);
  await app.field('Function 5, S2').click();
  for (const key of [...Array(5).fill('ArrowDown'), ...Array(10).fill('ArrowUp')]) {
    await app.page.keyboard.press(key);
    await expect.poll(() => seen('td input:focus'), { message: key }).toEqual(['seen']);
  }
  for (let row = 1; row <= 10; row++) {
    await app.page.keyboard.press('Shift+ArrowDown');
    // The corner that moves. A bar comes up with the range and may still push it.
    await expect
      .poll(async () => (await seen('td.selected input')).at(-1), { message: `${row} rows further` })
      .toBe('seen');
  }
});

test('what is beside the table moves down when there is a notice to read', async () => {
  const app = await AppPage.open({ bench: { granted: true } });
  await app.connect();
  await app.type('Function 2, S1', '7');
  await app.fly('M2');
  await app.says('Your edits of the other memory are kept.');
  await app.page.mouse.wheel(0, 400);
  const edges = () =>
    app.page.evaluate(() => {
      const [head, side] = ['.top', '.program-side'].map((name) => document.querySelector(name));
      return (side?.getBoundingClientRect().top ?? 0) >= (head?.getBoundingClientRect().bottom ?? 0);
    });
  await expect.poll(() => app.page.evaluate(() => scrollY)).toBeGreaterThan(0);
  await expect.poll(edges).toBe(true);
});

test('nothing stands over the edge of the smallest phone: five memories, and three ways to connect', async () => {
  const app = await AppPage.open({
    ...PHONE,
    viewport: { width: 320, height: 700 },
    bench: { granted: true, identity: { memories: 5 } },
    before: () => location.protocol !== 'about:' && localStorage.setItem('sidus-timer/theme', '"sun"'),
  });
  await app.trySimulated('F1Q');
  await app.type('Function 2, S1', '7');
  await app.kept();
  await app.reload();
  await app.says('Your edits are back.');
  await app.expectNoSidewaysScrolling();
  await app.connect();
  const isIn = async (place: Locator): Promise<void> => {
    const box = await place.boundingBox();
    expect((box?.x ?? 0) + (box?.width ?? 0), String(place)).toBeLessThan(320);
  };
  await app.showFigures();
  await isIn(app.page.locator('.memories label').last());
  await app.button('Close the large figures').click();
  await app.goTo('Memories');
  await app.button('Copy to…: M1').click();
  await isIn(app.button('Copy M1 to M5…'));
  await app.expectNoSidewaysScrolling();
});

test('what can be done to the timer leaves a tablet room for the table', async () => {
  const app = await AppPage.open({
    viewport: { width: 768, height: 1024 },
    bench: { granted: true },
    before: () => location.protocol !== 'about:' && localStorage.setItem('sidus-timer/theme', '"sun"'),
  });
  await app.connect();
  await app.type('Function 2, S1', '7');
  const height = await app.page.locator('.actions').evaluate((bar) => (bar as HTMLElement).offsetHeight);
  expect(height).toBeLessThan(180);
});
