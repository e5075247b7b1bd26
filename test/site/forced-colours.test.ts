import type { Locator } from 'playwright';
import { expect, test } from 'vitest';
import { AppPage } from './app-page.js';

test('where colours are forced on the page, what is chosen and ticked can be seen', async () => {
  const app = await AppPage.open({ bench: { granted: true }, forcedColors: 'active', colorScheme: 'dark' });
  const grounds = (found: Locator, part?: string): Promise<string[]> =>
    found.evaluateAll((all, pseudo) => all.map((each) => getComputedStyle(each, pseudo).backgroundColor), part);
  const strokes = (found: Locator): Promise<string[]> =>
    found.evaluateAll((all) => all.map((each) => getComputedStyle(each).stroke));
  await app.connect();
  const [chosen, ...others] = await grounds(app.page.locator('.memories label > span'));
  expect(others).not.toContain(chosen);
  const ink = await app.page.evaluate(() => getComputedStyle(document.body).color);
  expect(
    new Set(await strokes(app.page.locator('.servo-line.front'))),
    'the lines have the colour of the text',
  ).toEqual(new Set([ink]));
  expect(await grounds(app.page.locator('.link-state.on'), '::before'), 'the dot of a timer is filled').toEqual([ink]);
  await app.page.locator('.presets button', { hasText: '3 min' }).click();
  const presets = await grounds(app.page.locator('.presets button'));
  expect(presets.filter((ground) => ground === chosen)).toHaveLength(1);

  const text = (found: Locator): Promise<string[]> =>
    found.evaluateAll((all) => all.map((each) => getComputedStyle(each).fill));
  expect(new Set(await text(app.page.locator('.lane-names text'))), 'the names of all lanes').toEqual(new Set([ink]));
  const lines = (found: Locator): Promise<string[]> =>
    found.evaluateAll((all) => all.map((each) => getComputedStyle(each).outlineStyle));
  await app.type('Function 2, S1', '7');
  // The last one is marked in another way.
  await app.type('Function 3, S1', '8');
  await expect.poll(() => lines(app.page.locator('.program-table .value.changed'))).toContain('dotted');

  const ways = await app.page
    .locator('.program-exits button')
    .evaluateAll((all) => all.map((each) => each.getBoundingClientRect()).map(({ left, right }) => [left, right]));
  expect(ways[1]?.[0], 'buttons with an edge stand apart').toBeGreaterThan(ways[0]?.[1] ?? 0);
  const { right } = await app.page.locator('.checks').evaluate((each) => each.getBoundingClientRect());
  expect(ways[1]?.[1], 'and not over the edge').toBeLessThanOrEqual(right);

  await app.page.goto(new URL('#bench', app.page.url()).href);
  await expect.poll(() => grounds(app.page.locator('.switch-track'), '::before')).toEqual([ink]);

  await app.page.goto(new URL('#settings', app.page.url()).href);
  const expert = app.page.getByRole('checkbox', { name: /^Expert/ });
  await expert.check();
  const [box] = await grounds(expert);
  const [tick] = await grounds(expert, '::before');
  expect(tick).not.toBe(box);
  const colours = app.page.getByRole('group', { name: 'Colours' }).locator('label');
  expect((await grounds(colours)).filter((ground) => ground === chosen)).toHaveLength(1);
});
