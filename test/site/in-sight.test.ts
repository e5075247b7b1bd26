import type { Locator } from 'playwright';
import { expect, test } from 'vitest';
import { HELP_PAGES } from '../../src/app/help/help.js';
import { en } from '../tools/en.js';
import { AppPage, edgesOf, hiddenOf, isInSight, linesOf } from './app-page.js';
import { IN_SUN, PHONE } from './page.js';

const TABLET = { viewport: { width: 820, height: 1180 }, hasTouch: true, isMobile: true };

/** A laptop at 200 %. */
const LOW = { width: 640, height: 400 };

test('the field with the focus, and the end of a range, are never covered by the bars at the edges', async () => {
  const app = await AppPage.connected({ viewport: LOW });
  await app.field('Function 5, S2').click();
  for (const key of [...Array(5).fill('ArrowDown'), ...Array(10).fill('ArrowUp')]) {
    await app.page.keyboard.press(key);
    await expect.poll(() => isInSight(app.page.locator('td input:focus')), { message: key }).toBe(true);
  }
  for (let row = 1; row <= 10; row++) {
    await app.page.keyboard.press('Shift+ArrowDown');
    // The moving corner. A bar opens with the range and may still push it.
    const corner = app.page.locator('td.selected input').last();
    await expect.poll(() => isInSight(corner), { message: `${row} rows further` }).toBe(true);
  }
});

test('the field with the focus stays in sight when notes above it get their room', async () => {
  const app = await AppPage.connected({ viewport: { width: 1366, height: 650 } });
  await app.field('Function 3 time').fill('10.50');
  await app.field('Function 5, S1').fill('999');
  const dt = app.field('DT time');
  await dt.focus();
  await app.page.locator('.row-notes').nth(1).waitFor();
  await expect.poll(() => isInSight(dt)).toBe(true);
});

test('the picture beside the table moves down when a notice appears', async () => {
  const app = await AppPage.connected();
  await app.type('Function 2, S1', '7');
  await app.fly('M2');
  await app.says(en.notes.kept.title);
  await app.page.mouse.wheel(0, 400);
  await expect.poll(() => app.page.evaluate(() => scrollY)).toBeGreaterThan(0);
  const [head, side] = ['.top', '.program-side'].map((part) => app.page.locator(part)) as [Locator, Locator];
  await expect.poll(async () => (await edgesOf(side)).top - (await edgesOf(head)).bottom).toBeGreaterThanOrEqual(0);
});

test('in a low window notices scroll away with the page, but what is known of the timer stays', async () => {
  const app = await AppPage.connected({ viewport: LOW });
  await app.type('DT time', '2:00');
  await app.bench((bench) => bench.adapter.unplug());
  await app.says(en.link.lost.title);
  /** How far below the upper edge these begin. One below 0 has scrolled away. */
  const places = () =>
    app.page.evaluate(() => {
      const place = (name: string) => Math.round(document.querySelector(name)?.getBoundingClientRect().top ?? -1) + 0;
      return { strip: place('.strip'), links: place('.view-links'), notice: place('.top .notice') };
    });
  await app.page.evaluate(() => scrollTo(0, 0));
  await expect.poll(places).toMatchObject({ notice: expect.toSatisfy((top: number) => top >= 0 && top < 50) });
  await app.page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight));
  await expect.poll(places).toEqual({ strip: 0, links: 47, notice: expect.toSatisfy((top: number) => top < -50) });
  // What has no room in it opens where the pilot is.
  await app.page.locator('.strip-more').click();
  await app.page.getByRole('button', { name: 'Close' }).waitFor();
  await expect.poll(places).toMatchObject({ strip: 0 });
});

test('nothing is wider than the smallest phone: five memories, and three ways to connect', async () => {
  const app = await AppPage.open({
    ...PHONE,
    viewport: { width: 320, height: 700 },
    bench: { granted: true, identity: { memories: 5 } },
    before: IN_SUN,
  });
  await app.trySimulated('F1Q');
  await app.type('Function 2, S1', '7');
  await app.kept();
  await app.reload();
  await app.says(en.notes.back.title);
  await app.expectNoSidewaysScrolling();
  await app.connect();
  const isIn = async (place: Locator): Promise<void> => {
    expect((await edgesOf(place)).right, `beyond the right edge: ${place}`).toBeLessThan(320);
  };
  await app.showFigures();
  await isIn(app.page.locator('.memories label').last());
  await app.goTo('Memories');
  await app.page.locator('.strip-more[aria-expanded=false]').waitFor();
  await app.page.getByLabel('Copy to…: M1', { exact: true }).click();
  await isIn(app.button('Copy M1 to M5'));
  await app.expectNoSidewaysScrolling();
  for (const help of HELP_PAGES) {
    await app.page.evaluate((hash) => location.assign(hash), `#help/${help}`);
    await app.page
      .locator('.help-nav [aria-current]')
      .and(app.page.locator(`[href$="${help}"]`))
      .waitFor();
    await app.expectNoSidewaysScrolling();
  }
});

test('on a small phone in the sun the buttons of a memory stand on one line, and its copy shows all servos', async () => {
  const app = await AppPage.simulated({ ...PHONE, viewport: { width: 360, height: 740 }, before: IN_SUN });
  await app.readAll();
  await app.button('Compare with M1: M4').waitFor();
  for (const actions of await app.page.locator('.card-actions').all())
    expect(await linesOf(actions.locator('> *'))).toBe(1);
  await app.page.getByLabel('Copy to…: M1', { exact: true }).click();
  await app.button('Copy M1 to M3').click();
  const grid = app.page.getByRole('dialog').locator('.program-grid');
  await grid.waitFor();
  expect(await hiddenOf(grid)).toBe(0);
});

test('on a tablet the figure of the timeline and its name have room, and the dot of a timer stands before its name', async () => {
  const app = await AppPage.connected(TABLET);
  const state = app.page.locator('.link-state');
  expect(
    await state.evaluate((each) => each.clientHeight / Number.parseFloat(getComputedStyle(each).lineHeight)),
  ).toBeLessThan(2);
  await app.field('Function 4 time').click();
  const name = app.page.locator('.timeline-readout span');
  const { bottom } = await edgesOf(name);
  expect(bottom).toBeLessThanOrEqual(
    (await edgesOf(app.page.locator('.timeline-moment').filter({ has: name }))).bottom,
  );
});

test('the buttons for the timer leave room for the table on a tablet', async () => {
  const app = await AppPage.connected({
    viewport: { width: 768, height: 1024 },
    before: IN_SUN,
  });
  await app.type('Function 2, S1', '7');
  expect((await edgesOf(app.actions)).height).toBeLessThan(180);
});

test('on a desktop two memories stand beside each other, with the buttons of each on one line', async () => {
  const app = await AppPage.connected({
    viewport: { width: 1366, height: 650 },
    before: IN_SUN,
  });
  // A memory that was read has the most buttons.
  await app.readAll();
  await app.button('Compare with M1: M4').waitFor();
  expect(await linesOf(app.page.locator('.memory-card')), 'four in two columns').toBe(2);
  for (const actions of await app.page.locator('.card-actions').all())
    expect(await linesOf(actions.locator('> *'))).toBe(1);
});

test.each([3, 5])('on a small phone in the sun functions are in sight above the trim of %i servos', async (servos) => {
  const app = await AppPage.connected({
    ...PHONE,
    viewport: { width: 360, height: 740 },
    bench: { identity: { servos } },
    before: IN_SUN,
  });
  await app.goTo('Bench');
  await app.page.getByRole('checkbox', { name: /^The propeller/ }).check();
  await app.button('Next').click();
  await app.text('Servos at start').waitFor();
  // The start and a function, at least.
  const second = app.page.locator('.bench-table tbody tr').nth(1);
  const below = async () => (await edgesOf(second)).bottom - (await edgesOf(app.page.locator('.bench-trim'))).top;
  await expect.poll(below).toBeLessThanOrEqual(0);
});

test.each([
  ['a desktop', { viewport: { width: 1280, height: 800 } }],
  ['a small phone', { ...PHONE, viewport: { width: 360, height: 740 } }],
] as const)('255 memories, 20 functions and 8 servos leave everything in reach on %s', async (device, options) => {
  const identity = { memories: 255, functions: 20, servos: 8 };
  const app = await AppPage.connected({ bench: { identity }, ...options });
  await expect.poll(() => isInSight(app.field('Function 1, S1'))).toBe(true);
  await expect.poll(() => isInSight(app.button(/^Write/))).toBe(true);
  if (device === 'a small phone') await app.page.locator('.strip-more').click();
  const list = app.page.getByRole('combobox', { name: en.program.memory, exact: true });
  await expect.poll(() => isInSight(list)).toBe(true);
  await list.selectOption('254');
  await app.text('M255 has not been read').waitFor();
  await app.expectNoSidewaysScrolling();
  await app.goTo('Memories');
  await app.page.getByLabel('Copy to…: M1', { exact: true }).click();
  const pick = app.button('Copy M1 to M255');
  await pick.scrollIntoViewIfNeeded();
  await expect.poll(() => isInSight(pick)).toBe(true);
  await app.expectNoSidewaysScrolling();
  await app.goTo('Bench');
  await app.page.locator('.bench-table').waitFor();
  await app.expectNoSidewaysScrolling();
});

test('in the sun the strip of a phone on its side stays one line beside the keys for a finger', async () => {
  const app = await AppPage.open({ ...PHONE, viewport: { width: 844, height: 390 }, before: IN_SUN });
  await app.button('Try a simulated F1Q timer').tap();
  await app.page.getByText('As in the timer, read').waitFor();
  await app.field('Function 2, S1').tap();
  await app.page.locator(':root[data-sheet]').waitFor();
  await expect.poll(async () => (await edgesOf(app.page.locator('.strip-line'))).height).toBeLessThan(60);
});

test('the promise about the propeller stands beside the button that waits for it, however long the rest is', async () => {
  const app = await AppPage.connected({ viewport: { width: 844, height: 390 }, before: IN_SUN });
  await app.type('DT time', '6:00');
  await app.button(/^Write( 1 change)?…$/).click();
  const dialog = app.page.getByRole('dialog');
  const tick = dialog.getByRole('checkbox', { name: /^The propeller/ });
  await expect.poll(() => isInSight(tick)).toBe(true);
  await app.page.setViewportSize({ width: 390, height: 500 });
  await expect.poll(() => dialog.evaluate((it) => it.scrollHeight > it.clientHeight)).toBe(true);
  await expect.poll(() => isInSight(tick)).toBe(true);
});

test('what warns before a write is in sight with its tick, above a long difference, and why Write is grey', async () => {
  const app = await AppPage.connected({ viewport: { width: 1366, height: 650 }, before: IN_SUN });
  for (let i = 1; i <= 9; i++) await app.type(`Function ${i}, S1`, '7');
  await app.type('Motor stop time', '4:00');
  await app.review();
  const words = [
    en.write.acknowledge,
    en.write.stillToTick({ ticks: `${en.write.ticks.warnings}, ${en.write.ticks.safety}` }),
  ];
  for (const sentence of words) {
    expect(await isInSight(app.dialog.getByText(sentence)), sentence).toBe(true);
  }
});

test('on a phone on its side the way to stop following is in the window, with all commands of the program', async () => {
  const app = await AppPage.connected({ viewport: { width: 844, height: 390 }, before: IN_SUN });
  await app.follow();
  await app.goTo('Program');
  await app.button(en.bench.stopFollowing).waitFor();
  const outside = await app.page.locator('.actions button').evaluateAll((buttons) =>
    buttons.flatMap((button) => {
      const { left, right, top, bottom } = button.getBoundingClientRect();
      const there = document.elementFromPoint((left + right) / 2, bottom - 2);
      return top >= 0 && bottom <= innerHeight && button.contains(there) ? [] : [button.textContent];
    }),
  );
  expect(outside).toEqual([]);
});

test.each([
  ['in the light', undefined],
  ['in the sun', IN_SUN],
] as const)(
  'on a desktop the checks are in sight %s, also above the note that the servos follow',
  async (_, before) => {
    const app = await AppPage.connected({
      viewport: { width: 1280, height: 800 },
      ...(before && { before }),
    });
    /** How much of the line of the checks lies below the upper edge of the commands. */
    const covered = async () => (await edgesOf(app.page.locator('.checks'))).bottom - (await edgesOf(app.actions)).top;
    await expect.poll(covered).toBeLessThanOrEqual(0);
    await app.follow();
    await app.button('Next').click();
    await app.text('Servos at start').waitFor();
    await app.goTo('Program');
    await app.type('Start, S1', '7');
    await app.text('1 tried in the timer').first().waitFor();
    await expect.poll(covered).toBeLessThanOrEqual(0);
  },
);

test.each([
  ['a small phone', { width: 360, height: 740 }],
  ['a phone on its side', { width: 844, height: 390 }],
])('in the sun the player has one line of buttons on %s', async (_, viewport) => {
  const app = await AppPage.simulated({ ...PHONE, viewport, before: IN_SUN });
  await app.button('Picture').tap();
  await expect.poll(() => linesOf(app.page.locator('.preview-controls button'))).toBe(1);
});

test('on a phone, the sign of the last column and what is said of a memory that is looked at keep off the edges', async () => {
  const app = await AppPage.connected(PHONE);
  const last = app.page.getByRole('button', { name: 'Tools for S3' });
  const end = await last.evaluate((button) => getComputedStyle(button, '::after').insetInlineEnd);
  expect(Number.parseFloat(end)).toBeGreaterThan(2);
  await app.lookAt('M2');
  const { left } = await edgesOf(app.page.getByRole('heading', { name: 'M2 has not been read' }));
  expect(left).toBeGreaterThanOrEqual(8);
});

test.each([
  ['tools of a row', (app: AppPage) => app.button('Tools for Function 4'), '.row-panel'],
  ['keys for a finger', (app: AppPage) => app.field('Function 4, S2'), '.edit-sheet'],
] as const)('on a tablet the %s lie beside the table, and the page stays as it was', async (_, opener, sheet) => {
  const app = await AppPage.open({ ...TABLET, before: IN_SUN });
  await app.button('Try a simulated F1Q timer').tap();
  await app.page.getByText('As in the timer, read').waitFor();
  expect((await edgesOf(app.page.locator('.strip-line'))).height, 'not word below word').toBeLessThan(80);
  const page = () => app.page.evaluate(() => [scrollY, document.documentElement.scrollHeight]);
  const before = await page();
  await opener(app).tap();
  const [beside, table] = [await edgesOf(app.page.locator(sheet)), await edgesOf(app.table)];
  expect(beside.left).toBeGreaterThanOrEqual(table.right);
  expect(beside.right, 'nothing stands out beside it').toBe(TABLET.viewport.width);
  expect(await page()).toEqual(before);
});

test('on a desktop the tools of a row do not reach over the picture', async () => {
  const app = await AppPage.connected({ viewport: { width: 1280, height: 800 }, before: IN_SUN });
  await app.button('Tools for Motor stop').click();
  const [panel, table] = [await edgesOf(app.page.locator('.row-panel')), await edgesOf(app.table)];
  const times = await edgesOf(app.field('Function 5 time'));
  expect(panel.right).toBeLessThanOrEqual(table.right);
  expect(panel.left, 'the times that move stay in sight').toBeGreaterThan(times.right - 12);
});

test('on a phone on its side nothing of a new program is below the edge', async () => {
  const app = await AppPage.open({ ...PHONE, viewport: { width: 844, height: 390 }, before: IN_SUN });
  await app.button(en.newProgram.title).tap();
  const dialog = app.page.getByRole('dialog', { name: 'New program' });
  await dialog.waitFor();
  const [caution, buttons] = [
    await edgesOf(dialog.getByText('The positions of your model are not known here.')),
    await edgesOf(dialog.locator('.buttons')),
  ];
  expect(caution.bottom).toBeLessThanOrEqual(buttons.top);
});
