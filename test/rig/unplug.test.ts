import { expect, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { Pilot } from './pilot.js';
import { type Direction, Rig } from './rig.js';

// Where the plug is pulled, in bytes from the start of the job, and in which direction they are counted: inside a
// frame, between two, in the first and the last of the job.
const whileReading: [Direction, number[]][] = [
  ['fromPage', [4, 20]],
  ['toPage', [1, 33, 82]],
];
const whileWriting: [Direction, number[]][] = [
  ['fromPage', [4, 27, 45, 64]],
  ['toPage', [3, 26, 59, 141]],
];

/** Plugs the adapter in again, and the connection comes back by itself. */
async function comesBack(rig: Rig, pilot: Pilot): Promise<void> {
  await pilot.isAway();
  await rig.plug();
  await pilot.isConnected();
}

test.for(whileReading)(
  'unplugged while the page reads, counted %s: the page says so, and nothing typed is lost',
  async ([direction, cuts]) => {
    const rig = await Rig.start();
    const pilot = new Pilot(await rig.open());
    await pilot.clickConnect();
    await pilot.isConnected();
    const typed = { 'Function 9 time': '7.25', 'Start, S2': '0', 'Function 4, S3': 'x' };
    await pilot.type(typed);
    for (const bytes of cuts) {
      const unplugged = rig.unplugAfter(bytes, direction);
      await pilot.button(en.program.read).click();
      await unplugged;
      await pilot.isAway();
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
    await pilot.type(good);
    await pilot.write();
    expect(await pilot.result()).toContain(en.write.verified.title);
    const { times, positions } = rig.timer.core.content;
    expect([times[9], positions[1]?.[0], positions[2]?.[4]]).toEqual([725, 0, 54]);
  },
);

test.for(whileWriting)(
  'unplugged while the page writes, counted %s: the page says so, and a second write finishes it',
  async ([direction, cuts]) => {
    const rig = await Rig.start();
    const pilot = new Pilot(await rig.open());
    await pilot.clickConnect();
    await pilot.isConnected();
    for (const [index, bytes] of cuts.entries()) {
      const typed = { 'DT time': `2:0${index}`, 'Function 3, S1': `${index}`, 'DT, S3': `${100 + index}` };
      await pilot.type(typed);
      await pilot.review();
      const unplugged = rig.unplugAfter(bytes, direction);
      await pilot.startWriting();
      await unplugged;
      expect(await pilot.writeEnds(), `the end of a write with the cable pulled after ${bytes} bytes`).not.toContain(
        en.write.verified.title,
      );
      expect(
        await pilot.shown(Object.keys(typed)),
        `the fields after the cable was pulled after ${bytes} bytes`,
      ).toEqual(typed);
      await comesBack(rig, pilot);
      expect(
        await pilot.shown(Object.keys(typed)),
        `the fields after the return, with the cable pulled after ${bytes} bytes`,
      ).toEqual(typed);
      await pilot.write();
      expect(await pilot.result(), `the second write, after the cable was pulled after ${bytes} bytes`).toContain(
        en.write.verified.title,
      );
      const { times, positions } = rig.timer.core.content;
      expect([times[10], positions[0]?.[3], positions[2]?.[10]]).toEqual([12_000 + 100 * index, index, 100 + index]);
    }
  },
);

test('an adapter that fails while it is plugged in is reported as lost, and later as unplugged', async () => {
  const rig = await Rig.start();
  const pilot = new Pilot(await rig.open());
  await pilot.clickConnect();
  await pilot.isConnected();
  await pilot.type({ 'Function 9 time': '7.25' });
  await rig.breakAdapter();
  await pilot.sees(en.link.lost.title);
  await rig.unplug();
  await pilot.isAway();
  await comesBack(rig, pilot);
  expect(await pilot.shown(['Function 9 time'])).toEqual({ 'Function 9 time': '7.25' });
});
