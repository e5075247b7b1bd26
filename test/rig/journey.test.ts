import { expect, test } from 'vitest';
import { exchangeSize } from '../../src/protocol/index.js';
import { fromHex, toHex } from '../tools/bytes.js';
import { en } from '../tools/en.js';
import { connected, Pilot } from './pilot.js';
import { Rig } from './rig.js';

const identity = { timerClass: 'B', firmware: '536', functions: 10, memories: 4, servos: 3 } as const;

/** The one reply known from a real timer, to GETSERVOPOS, in the pieces in which it came. */
const capture = [
  '00',
  '00',
  '00 00 00 24 68 0f 19 23 2d 37',
  '41 4b 55 5f 69 73 0f 19 23',
  '2d 37 41 4b 55 5f 69 73 0f 19',
  '23 2d 37 41 4b 55 5f 69 73 c9',
  '45',
].map(fromHex);

test('the page shows what a real timer has sent', async () => {
  const before = (['GETSWVER', 'GETMEMORY', 'GETTIMERS'] as const).map((name) => exchangeSize(name, identity).reply);
  const chunks = [...before, ...capture.map(({ length }) => length)];
  const { rig, pilot } = await connected({ timer: { identity, baudRate: 9600, fromTimer: { chunks } } });

  await pilot.sees('F1B');
  await pilot.sees('firmware 536');
  expect(rig.settings).toEqual({ baudRate: 9600, stopBits: 1, flowControl: 'none' });
  const bytes = toHex(Uint8Array.from(rig.passed.toPage));
  expect(bytes).toContain(capture.map(toHex).join(' '));
  const slots = ['Start', ...[1, 2, 3, 4, 5, 6, 7, 8, 9].map((n) => `Function ${n}`), 'DT'];
  const names = ['S1', 'S2', 'S3'].flatMap((servo) => slots.map((slot) => `${slot}, ${servo}`));
  const positions = ['15', '25', '35', '45', '55', '65', '75', '85', '95', '105', '115'];
  expect(Object.values(await pilot.shown(names))).toEqual([...positions, ...positions, ...positions]);
});

test('a time and two positions are written with one SETTIMERS and two SETSERVO, and verified', async () => {
  const { rig, pilot } = await connected({ timer: { identity } });
  const { core } = rig.timer;
  const times = [...core.content.times.slice(0, 10), 15_000];
  const asked = core.answered.length;

  const typed = { 'DT time': '2:30', 'Function 3, S1': '44', 'DT, S3': '130' };
  await pilot.enter(typed);
  await pilot.write();
  expect(await pilot.outcome()).toContain(en.write.verified.title);

  const who = { name: 'GETSWVER' };
  const memory = { name: 'GETMEMORY' };
  const content = [{ name: 'GETTIMERS' }, { name: 'GETSERVOPOS' }];
  expect(core.answered.slice(asked)).toEqual([
    // What the dialog shows, and what is held when the pilot has agreed.
    ...[memory, ...content, memory, who],
    ...[who, memory, ...content, memory, who],
    { name: 'SETTIMERS', times },
    { name: 'SETSERVO', function: 3, servo: 0, position: 44 },
    { name: 'SETSERVO', function: 10, servo: 2, position: 130 },
    ...[who, memory, ...content, ...content, memory, who],
  ]);
  expect(core.content.times[10]).toBe(15_000);
  expect([core.content.positions[0]?.[3], core.content.positions[2]?.[10]]).toEqual([44, 130]);
  expect(await pilot.shown(Object.keys(typed))).toEqual(typed);
  expect(rig.settings?.baudRate).toBe(9600);

  await pilot.button(en.header.disconnect).click();
  await expect.poll(() => rig.sessions, { timeout: 60_000 }).toEqual({ opened: 1, closed: 1 });
});

test('a port that another program uses is reported as in use, and is connected when it is free', async () => {
  const rig = await Rig.start({ timer: { identity } });
  const pilot = new Pilot(await rig.open());
  await rig.whileHeld(async () => {
    await pilot.clickConnect();
    await pilot.sees(en.link.refused);
  });
  await pilot.isReady();
});
