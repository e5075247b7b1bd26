import { expect, test } from 'vitest';
import { HOLD } from '../../src/app/ui/press-and-hold.js';
import { COMMANDS, type CommandName, encodeFrame } from '../../src/protocol/index.js';
import { en } from '../tools/en.js';
import { connected, type Pilot } from './pilot.js';
import type { Rig, RigOptions } from './rig.js';

const BAUD_RATE = 9600;
/** A byte on the line: start bit, eight bits, stop bit. */
const BITS = 10;

/** A pilot at the bench, with an F1Q at a line of 9600 baud, who has said that it is safe. */
async function atTheBench(options: RigOptions = {}): Promise<{ rig: Rig; pilot: Pilot }> {
  const { rig, pilot } = await connected({ timer: { identity: { timerClass: 'Q' }, baudRate: BAUD_RATE }, ...options });
  await pilot.goTo('Bench');
  await pilot.page.getByRole('checkbox', { name: en.write.safety }).check();
  return { rig, pilot };
}

const sent = ({ requests }: Rig, name: CommandName): number =>
  requests.filter((code) => code === COMMANDS[name].request).length;

test('the servo that is trimmed moves, no faster than the line carries, where the pilot lets it; then all is put back', async () => {
  // Storing alone moves nothing here: what moves was told to.
  const timer = { identity: { timerClass: 'Q' }, baudRate: BAUD_RATE, quirks: { setMoves: 'never' } } as const;
  const { rig, pilot } = await atTheBench({ asks: ['MOVETOFUNC'], timer });
  const { keyboard } = pilot.page;
  const { core } = rig.timer;
  const before = core.content.positions.map((row) => [...row]);
  const stand = (): [slot: number, servos: number[]] => [core.slot, core.servos];
  const toggle = pilot.page.getByRole('switch', { name: en.bench.follow });
  await pilot.button('Function 2').click();
  await pilot.sees(en.bench.at({ slot: 'function 2' }));
  expect(stand()).toEqual([2, [35, 35, 35]]);
  await toggle.click();
  await pilot.sees(en.bench.followingNow);
  expect(sent(rig, 'SETSERVO'), 'no position is sent before one is changed').toBe(0);

  await pilot.goTo('Program');
  await pilot.field('Function 2, S1').focus();
  await keyboard.press('Alt+ArrowUp');
  // The first position of each following is read back before its servo moves.
  await expect.poll(stand).toEqual([2, [36, 35, 35]]);
  await expect.poll(() => rig.frames.at(-1)?.code).toBe(COMMANDS.MOVETOFUNC.reply);
  const begin = rig.frames.length;
  // A key that is held: 59 more positions of one servo, where they stand.
  await keyboard.down('Alt');
  for (let i = 0; i < 59; i++) await keyboard.down('ArrowUp');
  await keyboard.up('ArrowUp');
  await keyboard.up('Alt');
  await pilot.sees(en.bench.triedAndWaiting({ tried: 1, waiting: 0 }));
  await expect.poll(stand).toEqual([2, [95, 35, 35]]);
  const { SETSERVO, MOVETOFUNC } = COMMANDS;
  await expect.poll(() => rig.frames.at(-1)?.code).toBe(MOVETOFUNC.reply);

  const frames = rig.frames.slice(begin);
  const exchanges = Array.from({ length: frames.length / 4 }, () => [
    ['fromPage', SETSERVO.request],
    ['toPage', SETSERVO.reply],
    ['fromPage', MOVETOFUNC.request],
    ['toPage', MOVETOFUNC.reply],
  ]).flat();
  expect(
    frames.map(({ direction, code }) => [direction, code]),
    'each position is sent as SETSERVO and MOVETOFUNC, each request after the reply to the one before',
  ).toEqual(exchanges);
  const [first, ...others] = frames;
  const bits = BITS * others.reduce((sum, { code, data }) => sum + encodeFrame(code, data).length, 0);
  const time = (others.at(-1)?.at ?? 0) - (first?.at ?? 0);
  expect(bits).toBeLessThanOrEqual((BAUD_RATE * time) / 1000);
  const stepped = core.answered.flatMap((request) => (request.name === 'SETSERVO' ? [request.position] : []));
  expect(stepped, 'the servo never moves back').toEqual([...new Set(stepped)].sort((a, b) => a - b));
  expect(stepped.length).toBeLessThanOrEqual(60);

  // Another function waits for a click.
  const moves = sent(rig, 'MOVETOFUNC');
  await pilot.field('Function 5, S2').fill('70');
  await pilot.field('Function 5, S2').blur();
  await pilot.sees(en.bench.triedAndWaiting({ tried: 1, waiting: 1 }));
  expect([core.content.positions[1]?.[5], sent(rig, 'MOVETOFUNC')]).toEqual([65, moves]);
  await pilot.button(en.bench.bring({ slot: 'function 5' })).click();
  await pilot.sees(en.bench.triedAndWaiting({ tried: 2, waiting: 0 }));
  await expect.poll(stand).toEqual([5, [65, 70, 65]]);

  await pilot.field('DT, S3').fill('12');
  await pilot.field('DT, S3').blur();
  await pilot.button(en.bench.bring({ slot: 'DT' })).click();
  await pilot.sees(en.bench.triedAndWaiting({ tried: 3, waiting: 0 }));
  await expect.poll(stand).toEqual([10, [115, 115, 12]]);

  const tried = before.map((row) => [...row]);
  for (const [servo, slot, position] of [
    [0, 2, 95],
    [1, 5, 70],
    [2, 10, 12],
  ] as const) {
    (tried[servo] as number[])[slot] = position;
  }
  expect(core.content.positions).toEqual(tried);

  const asked = sent(rig, 'MOVETOFUNC');
  await pilot.button(en.bench.stopFollowing).click();
  await pilot.button(en.bench.putBack).click();
  await pilot.tickSafety();
  await pilot.startWriting();
  expect(await pilot.outcome()).toContain(en.write.verified.title);
  expect(core.content.positions).toEqual(before);
  await pilot.goTo('Bench');
  expect(await toggle.getAttribute('aria-checked')).toBe('false');
  expect(sent(rig, 'MOVETOFUNC'), 'a write sends no MOVETOFUNC').toBe(asked);
});

test('UNLOCK goes out once for each hold, however long that is, also with a key that repeats while it is held', async () => {
  const { rig, pilot } = await atTheBench({ asks: ['UNLOCK'] });
  const { keyboard, mouse } = pilot.page;
  const unlock = pilot.button(en.bench.unlock);
  await unlock.hover();
  await mouse.down();
  await expect.poll(() => rig.timer.core.motorLocked, { timeout: 5 * HOLD }).toBe(false);
  await pilot.sees(en.bench.unlocked);
  // What has not come until now does not come: two holds have passed, by the clock of the page.
  const began = await pilot.page.evaluate(() => performance.now());
  await pilot.page.waitForFunction((until) => performance.now() > until, began + 2 * HOLD);
  await mouse.up();
  expect(sent(rig, 'UNLOCK')).toBe(1);

  await unlock.focus();
  // Through the hold, the answer, and what would be a second hold.
  for (const end = performance.now() + 4 * HOLD; performance.now() < end; ) await keyboard.down('Space');
  await pilot.sees(en.bench.unlocked);
  // The button has lost the focus when it went out; where the answer is quicker than that, the next repeat finds it
  // again.
  await unlock.dispatchEvent('keydown', { key: ' ', repeat: true });
  expect(await pilot.button(en.bench.unlockHold).count(), 'a key that repeats does not begin a second hold').toBe(0);
  await keyboard.up('Space');
  expect(sent(rig, 'UNLOCK')).toBe(2);
});
