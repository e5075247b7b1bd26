import { expect, test } from 'vitest';
import { COMMANDS } from '../../src/protocol/index.js';
import { ROUTES, textOf } from '../site/mouse-routes.js';
import { en } from '../tools/en.js';
import type { Place } from './chooser.js';
import { Pilot } from './pilot.js';
import { Rig } from './rig.js';

const identity = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 } as const;

test('a drag with the mouse over the table, with real events of X, selects and moves no value', async () => {
  const rig = await Rig.start({ timer: { identity }, chooser: true });
  const page = await rig.open();
  const pilot = new Pilot(page);
  await pilot.clickConnect();
  await rig.chooser.shows(1);
  await rig.chooser.choose();
  await pilot.isReady();
  const { core } = rig.timer;
  const names = [...new Set(ROUTES.flatMap((route) => route.slice(0, 2)))];
  const before = await pilot.shown(names);
  const held = structuredClone(core.memories);
  await pilot.field('Function 1 time').evaluate((input) => {
    const head = document.querySelector('header')?.getBoundingClientRect().bottom ?? 0;
    scrollTo(0, scrollY + input.getBoundingClientRect().top - head - 60);
  });
  /** Where on the screen the window shows the page. */
  const window = await page.evaluate(() => {
    const frame = (outerWidth - innerWidth) / 2;
    return { x: screenX + frame, y: screenY + outerHeight - innerHeight - frame };
  });
  const onScreen = async (name: string): Promise<Place> => {
    const { x, y } = await textOf(pilot.field(name));
    return { x: window.x + x, y: window.y + y };
  };

  const moved: string[] = [];
  for (const [from, to, selected] of ROUTES) {
    // The text under the pointer is marked: that is what a browser takes hold of.
    await pilot.field(from).selectText();
    rig.screen.drag(await onScreen(from), await onScreen(to), 6);
    const isSelected = await page
      .getByRole('toolbar')
      .getByText(selected, { exact: true })
      .waitFor({ timeout: 5000 })
      .then(
        () => true,
        () => false,
      );
    const now = await pilot.shown(names);
    const wrong = names.filter((name) => now[name] !== before[name]);
    if (!isSelected || wrong.length > 0) moved.push(`${from} to ${to}: selected ${isSelected}, changed ${wrong}`);
  }
  expect(moved).toEqual([]);
  const sets: readonly number[] = [COMMANDS.SETTIMERS, COMMANDS.SETSERVO, COMMANDS.SETLOWRPM].map(
    (each) => each.request,
  );
  expect(rig.requests.filter((code) => sets.includes(code))).toEqual([]);
  expect(core.memories).toEqual(held);

  // The last range is of functions 3 to 5 of S1: the timer gets what it is filled with, and nothing else.
  await page.keyboard.press('Control+d');
  await pilot.write();
  expect(await pilot.outcome()).toContain(en.write.verified.title);
  const wanted = structuredClone(held);
  const row = wanted[0]?.positions[0] as number[];
  row[4] = row[3] as number;
  row[5] = row[3] as number;
  expect(core.memories).toEqual(wanted);
});
