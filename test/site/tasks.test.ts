import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { PHONE } from './page.js';
import { costText, Pilot } from './pilot.js';
import { positionField, ROWS, SHEET, timeField } from './sheet.js';

interface Tried {
  readonly app: AppPage;
  readonly pilot: Pilot;
  readonly byTouch: boolean;
}

const dialog = (app: AppPage) => app.page.getByRole('dialog');

/** What has to be typed into each field of the sheet, by the name of the field. */
const WANTED = new Map(
  ROWS.flatMap((_, row) => [
    [timeField(row), (SHEET.times[row] ?? '').replace(',', '.')] as const,
    ...SHEET.positions.map((servo, index) => [positionField(row, index), servo[row] ?? ''] as const),
  ]),
);

const focused = (app: AppPage): Promise<string> => app.page.evaluate(() => document.activeElement?.ariaLabel ?? '');

/** What a pilot does most, each from the program of a timer that has just been read. */
const TASKS: readonly [name: string, task: (tried: Tried) => Promise<void>][] = [
  [
    'change DT and a position, and write',
    async ({ app, pilot, byTouch }) => {
      await pilot.press(app.field('DT time'));
      await pilot.type('2:30');
      if (byTouch) await pilot.sheetKey('Done');
      await pilot.press(app.field('Function 4, S2'));
      await pilot.type('70');
      if (byTouch) await pilot.sheetKey('Done');
      await pilot.press(app.button('Write 2 changes…'));
      await pilot.press(app.dialog.getByRole('checkbox', { name: 'The propeller is off' }));
      await pilot.press(app.dialog.getByRole('button', { name: 'Write 2 changes' }));
      await app.result('Verified.');
      await pilot.press(app.dialog.getByRole('button', { name: 'Close' }));
      expect(await app.bench(({ content: { times, positions } }) => [times[10], positions[1]?.[4]])).toEqual([
        15000, 70,
      ]);
    },
  ],
  [
    'change DT in M3 while M1 flies next, and write',
    async ({ app, pilot, byTouch }) => {
      if (byTouch) await pilot.press(app.page.locator('.strip-more'));
      await pilot.press(app.page.locator('.memories label', { hasText: 'M3' }));
      await pilot.press(app.button('Edit M3'));
      await pilot.press(app.field('DT time'));
      await pilot.type('2:30');
      if (byTouch) await pilot.sheetKey('Done');
      await pilot.press(app.button('Write 1 change…'));
      await pilot.press(app.dialog.getByRole('checkbox', { name: 'The propeller is off' }));
      await pilot.press(app.dialog.getByRole('button', { name: 'Write 1 change' }));
      await app.result('Verified.');
      await pilot.press(app.dialog.getByRole('button', { name: 'Close' }));
      const held = await app.bench(({ adapter }) => {
        const { memory, memories } = adapter.timer.core;
        return { memory, memories };
      });
      expect([held.memory, held.memories[0]?.times[10], held.memories[2]?.times[10]]).toEqual([0, 18000, 15000]);
    },
  ],
  [
    'enter a whole program from a sheet',
    async ({ app, pilot, byTouch }) => {
      await pilot.press(app.field(positionField(0, 0)));
      for (let left = WANTED.size; left > 0; left--) {
        await pilot.type(WANTED.get(await focused(app)) ?? '');
        if (byTouch) await pilot.sheetKey(left > 1 ? /›$/ : 'Done');
        else await pilot.key(left > 1 ? 'Tab' : 'Enter');
      }
      await app.changes(44).waitFor({ state: 'attached' });
      const entries = await app.entries();
      for (const [field, text] of WANTED)
        expect(Number.parseFloat(entries[field] ?? ''), `the value of ${field}`).toBe(Number.parseFloat(text));
    },
  ],
  [
    'shift by 0.3 s from motor stop on',
    async ({ app, pilot }) => {
      await pilot.press(app.button('Tools for Motor stop'));
      for (let press = 0; press < 3; press++) await pilot.press(app.button(en.edits.shift.later));
      await expect
        .poll(async () => [await app.valueOf(en.program.motorStopTime), await app.valueOf('Function 9 time')])
        .toEqual(['10.3', '14.80']);
    },
  ],
  [
    'trim a servo at function 4',
    async ({ app, pilot }) => {
      await pilot.press(app.page.getByRole('link', { name: 'Bench', exact: true }));
      await pilot.press(app.page.getByRole('checkbox', { name: /^The propeller/ }));
      await pilot.press(app.button('Function 4'));
      await app.text('Servos at function 4').first().waitFor();
      await pilot.press(app.page.getByRole('switch', { name: 'Servos follow' }));
      await app.page.getByRole('switch', { name: 'Servos follow', checked: true }).waitFor();
      await pilot.press(app.button('+1: Function 4, S1'));
      await app.text('1 tried in the timer').first().waitFor({ state: 'attached' });
      expect(await app.bench(({ content }) => content.positions[0]?.[4])).toBe(56);
    },
  ],
  [
    'compare two memories, and copy one to another',
    async ({ app, pilot }) => {
      await pilot.press(app.page.getByRole('link', { name: 'Memories', exact: true }));
      await pilot.press(app.button(en.overview.readAll));
      await app.page.getByText('memories were read').waitFor();
      await pilot.press(app.button('Compare with M1: M2'));
      await pilot.press(app.page.getByRole('link', { name: 'Memories', exact: true }));
      await pilot.press(app.page.getByLabel('Copy to…: M1', { exact: true }));
      await pilot.press(app.button('Copy M1 to M2'));
      await pilot.press(dialog(app).getByRole('checkbox', { name: 'The propeller is off' }));
      await pilot.press(dialog(app).getByRole('button', { name: /^(Copy|Write)/ }));
      await dialog(app)
        .getByText(/verified/i)
        .first()
        .waitFor();
      await pilot.press(dialog(app).getByRole('button', { name: 'Close' }));
    },
  ],
];

const docs = readFileSync('docs/testing.md', 'utf8');

describe.each(TASKS)('what it costs to %s', (name, task) => {
  test.each([
    ['desktop', { viewport: { width: 1280, height: 800 } }],
    ['phone', PHONE],
  ] as const)('on a %s is what the docs say, with no scrolling', async (device, options) => {
    const app = await AppPage.open({ bench: { granted: true }, ...options });
    const byTouch = device === 'phone';
    await app.connect();
    const pilot = new Pilot(app, byTouch);
    await task({ app, pilot, byTouch });
    const row = docs.split('\n').find((line) => line.startsWith(`| ${name} |`)) ?? '';
    expect(row.split('|').map((cell) => cell.trim())[byTouch ? 5 : 3]).toBe(costText(pilot.cost, byTouch));
  });
});
