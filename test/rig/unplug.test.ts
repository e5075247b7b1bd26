import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { connected, type Pilot } from './pilot.js';
import type { Direction, Rig } from './rig.js';

// Where the plug is pulled, in bytes from the start of the job, and in which direction they are counted: inside a
// frame, between two, in the first and the last of the job. The same of a write is in survive.test.ts.
const whileReading: [Direction, number[]][] = [
  ['fromPage', [4, 20]],
  ['toPage', [1, 33, 82]],
];

/** Plugs the adapter in again, and the connection comes back by itself. */
async function comesBack(rig: Rig, pilot: Pilot): Promise<void> {
  await pilot.sees(en.link.lost.title);
  await rig.plug();
  await pilot.isReady();
}

test.for(whileReading)(
  'unplugged while the page reads, counted %s: the page says so, and nothing typed is lost',
  async ([direction, cuts]) => {
    const { rig, pilot } = await connected();
    const typed = { 'Function 9 time': '7.25', 'Start, S2': '0', 'Function 4, S3': 'x' };
    await pilot.enter(typed);
    for (const bytes of cuts) {
      const unplugged = rig.unplugAfter(bytes, direction);
      await pilot.button(en.program.read).click();
      await unplugged;
      await pilot.sees(en.link.lost.title);
      expect(
        await pilot.shown(Object.keys(typed)),
        `the fields after the cable was pulled after ${bytes} bytes`,
      ).toEqual(typed);
      await comesBack(rig, pilot);
      expect(
        await pilot.shown(Object.keys(typed)),
        `the fields after the return, with the cable pulled after ${bytes} bytes`,
      ).toEqual(typed);
    }
    const good = { 'Function 4, S3': '54' };
    await pilot.enter(good);
    await pilot.write();
    expect(await pilot.outcome()).toContain(en.write.verified.title);
    const { times, positions } = rig.timer.core.content;
    expect([times[9], positions[1]?.[0], positions[2]?.[4]]).toEqual([725, 0, 54]);
  },
);

test('an adapter that fails while it is plugged in is reported as lost, and later as unplugged', async () => {
  const { rig, pilot } = await connected();
  await pilot.enter({ 'Function 9 time': '7.25' });
  await rig.breakAdapter();
  await pilot.sees(en.link.lost.title);
  await rig.unplug();
  await pilot.sees(en.link.lost.title);
  await comesBack(rig, pilot);
  expect(await pilot.shown(['Function 9 time'])).toEqual({ 'Function 9 time': '7.25' });
});
