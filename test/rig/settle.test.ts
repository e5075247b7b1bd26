import { expect, test } from 'vitest';
import { COMMANDS, type CommandName } from '../../src/protocol/index.js';
import { en } from '../tools/en.js';
import { connected, type Pilot } from './pilot.js';

const identity = { timerClass: 'B', firmware: '536', functions: 10, memories: 4, servos: 3 } as const;

async function toWalk(pilot: Pilot): Promise<void> {
  await pilot.page.evaluate(() => location.assign('#settings/settle'));
  await pilot.page.getByRole('checkbox', { name: en.settle.safe }).check();
}

/** Reads, and goes on to the first position. */
async function toPosition(pilot: Pilot): Promise<void> {
  await pilot.button(en.settle.readIt).click();
  for (let i = 0; i < 3; i++) await pilot.button(en.next).click();
  await pilot.button(en.settle.ask).click();
  await pilot.button(en.bench.bring({ slot: 'DT' })).waitFor();
}

test('a walk with a timer that takes the servo first sends what was pressed, and leaves the timer as it was', async () => {
  const timer = { identity, baudRate: 9600, quirks: { servoFirst: true } };
  const { rig, pilot } = await connected({ timer, asks: ['MOVETOFUNC'] });
  const before = structuredClone(rig.timer.core.memories);
  const sent = (name: CommandName): number => rig.requests.filter((code) => code === COMMANDS[name].request).length;
  await toWalk(pilot);
  await toPosition(pilot);
  expect([sent('SETSERVO'), sent('MOVETOFUNC')], 'before the first press').toEqual([0, 0]);
  for (const [to, moved] of [
    ['DT', en.settle.no],
    ['function 1', en.settle.yes],
  ] as const) {
    await pilot.button(en.bench.bring({ slot: to })).click();
    await pilot.button(en.settle.tryIt).click();
    await pilot.sees(en.settle.moved);
    expect(rig.timer.core.memories).toEqual(before);
    await pilot.button(moved).click();
  }
  // The position went to another place and came back; then it went to the right one and came back.
  expect([sent('SETSERVO'), sent('MOVETOFUNC')]).toEqual([4, 2]);
  const answer = (name: string) =>
    pilot.page.locator('.settle-list > div', { hasText: name }).locator('dd').innerText();
  expect([
    await answer(en.settle.names.layout),
    await answer(en.settle.names.moves),
    await answer(en.settle.names.zeros),
  ]).toEqual([en.settle.no, en.settle.there, en.settle.yes]);
});

test('unplugged before the answer to a position that is tried: it is said until it is put back', async () => {
  const { rig, pilot } = await connected({ timer: { identity, baudRate: 9600 }, asks: ['MOVETOFUNC'] });
  const before = structuredClone(rig.timer.core.memories);
  await toWalk(pilot);
  await toPosition(pilot);
  await pilot.button(en.bench.bring({ slot: 'DT' })).click();
  await pilot.sees(en.bench.at({ slot: 'DT' }));
  const out = new Promise<void>((resolve) => {
    rig.timer.core.onAnswer = ({ name }) => {
      if (name === 'SETSERVO') void rig.unplug().then(resolve);
    };
  });
  await pilot.button(en.settle.tryIt).click();
  await out;
  await pilot.page.getByRole('region', { name: 'Not certain' }).getByText('Function 1, S1 is').waitFor();
  expect(rig.timer.core.memories).not.toEqual(before);
  rig.timer.core.onAnswer = undefined;
  await rig.plug(1);
  await pilot.button(en.recovery.finish).click();
  await pilot.tickSafety();
  await pilot.startWriting();
  await pilot.sees(en.write.verified.title);
  expect(rig.timer.core.memories).toEqual(before);
});
