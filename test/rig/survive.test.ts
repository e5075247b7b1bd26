import { stdout } from 'node:process';
import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { connected, Pilot } from './pilot.js';
import type { Direction, Rig } from './rig.js';

/** What is written in these tests: one SETTIMERS and three SETSERVO. */
const values = (round: number) => ({
  'DT time': `2:${10 + round}`,
  'Function 3, S1': `${round}`,
  'Function 5, S2': `${30 + round}`,
  'DT, S3': `${80 + round}`,
});

/** Where the timer holds these, as it counts. */
const held = ({ timer: { core } }: Rig) => {
  const { times, positions } = core.content;
  return [times[10], positions[0]?.[3], positions[1]?.[5], positions[2]?.[10]];
};
const wanted = (round: number) => [100 * (130 + round), round, 30 + round, 80 + round];

/** Milliseconds that `work` takes. */
async function timed(work: () => Promise<void>): Promise<number> {
  const begin = performance.now();
  await work();
  return performance.now() - begin;
}

/** Finishes what was interrupted, in whatever way the page offers it, and looks that the timer holds it all. */
async function bringToEnd(rig: Rig, pilot: Pilot, round: number): Promise<'offered' | 'again' | 'complete'> {
  const isOffered = await pilot.page.getByRole('region', { name: en.recovery.title }).isVisible();
  const way = isOffered
    ? 'offered'
    : held(rig).every((value, at) => value === wanted(round)[at])
      ? 'complete'
      : 'again';
  expect(await pilot.shown(Object.keys(values(round)))).toEqual(values(round));
  if (way === 'complete') {
    await pilot.sees(en.notes['write-completed'].title);
  } else {
    if (way === 'offered') {
      await pilot.button(en.recovery.finish).click();
      await pilot.tickSafety();
      await pilot.startWriting();
    } else await pilot.write();
    expect(await pilot.outcome()).toContain(en.write.verified.title);
  }
  expect(held(rig)).toEqual(wanted(round));
  return way;
}

test('plugged in again, also under another name, the connection is back in a moment, with what was typed', async () => {
  const { rig, pilot } = await connected();
  await pilot.enter(values(1));
  const times: number[] = [];
  for (const number of [0, 0, 0, 1, 2, 0]) {
    await pilot.page.evaluate(async () => Object.assign(globalThis, { before: await navigator.serial.getPorts() }));
    await rig.unplug();
    await pilot.sees(en.link.lost.title);
    const time = await timed(async () => {
      await rig.plug(number);
      await pilot.isReady();
    });
    times.push(Math.round(time));
    expect(await pilot.shown(Object.keys(values(1)))).toEqual(values(1));
    expect(await isNewObject(pilot), 'Chromium gives a new port object each time').toBe(true);
  }
  stdout.write(`From plugging in to the program on the screen: ${times.join(', ')} ms.\n`);
  await pilot.write();
  expect(await pilot.outcome()).toContain(en.write.verified.title);
  expect(held(rig)).toEqual(wanted(1));
});

function isNewObject(pilot: Pilot): Promise<boolean> {
  return pilot.page.evaluate(async () => {
    const { before } = globalThis as unknown as { before: SerialPort[] };
    const [port] = await navigator.serial.getPorts();
    return port !== undefined && !before.includes(port);
  });
}

/** Pseudo-random whole numbers below `limit`, always the same ones (mulberry32). */
function* below(limit: number, seed: number): Generator<number, never> {
  for (let state = seed; ; ) {
    state = (state + 0x6d2b79f5) | 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    yield ((mixed ^ (mixed >>> 14)) >>> 0) % limit;
  }
}

test.for<[Direction, number]>([
  ['fromPage', 1],
  ['toPage', 2],
])(
  'unplugged after each of 25 random bytes of a write, counted %s: it comes back without a click, and the write is finished',
  { timeout: 180_000 },
  async ([direction, seed]) => {
    const { rig, pilot } = await connected();
    // How many bytes a whole write takes.
    await pilot.enter(values(0));
    await pilot.prepare();
    const before = rig.passed[direction].length;
    await pilot.startWriting();
    expect(await pilot.outcome()).toContain(en.write.verified.title);
    const whole = rig.passed[direction].length - before;

    const cuts = below(whole, seed);
    const ways = { offered: 0, again: 0, complete: 0 };
    const time = await timed(async () => {
      for (let round = 1; round <= 25; round++) {
        const bytes = 1 + cuts.next().value;
        await pilot.enter(values(round));
        await pilot.prepare();
        const unplugged = rig.unplugAfter(bytes, direction);
        await pilot.startWriting();
        await unplugged;
        await pilot.writeEnds();
        await pilot.sees(en.link.lost.title);
        await rig.plug();
        await pilot.isReady();
        ways[await bringToEnd(rig, pilot, round)]++;
      }
    });
    const counts = Object.entries(ways).map(([way, count]) => `${way} ${count}`);
    stdout.write(
      `A write of ${whole} bytes ${direction}, cut 25 times in ${Math.round(time / 1000)} s: ${counts.join(', ')}.\n`,
    );
    expect(ways.offered).toBeGreaterThan(0);
  },
);

/** Begins a write and covers the infrared head in the middle of it: after the times, and before the last position. */
async function halfWritten(): Promise<{ rig: Rig; pilot: Pilot }> {
  const { rig, pilot } = await connected();
  await pilot.enter(values(1));
  await pilot.prepare();
  // The fresh reading takes 63 bytes, SETTIMERS 31, each SETSERVO 12.
  const covered = rig.coverAfter(63 + 31 + 12 + 8, 'fromPage');
  await pilot.startWriting();
  await covered;
  const [time, , , last] = held(rig);
  expect(
    [time === wanted(1)[0], last === wanted(1)[3]],
    'the write was interrupted in the middle: the time is written, the last position is not',
  ).toEqual([true, false]);
  return { rig, pilot };
}

test('the page is loaded again in the middle of a write: it warns, and offers to finish', async () => {
  const { rig, pilot } = await halfWritten();
  const warned = pilot.page.waitForEvent('dialog').then(async (dialog) => {
    await dialog.accept();
    return dialog.type();
  });
  await pilot.page.reload();
  expect(await warned).toBe('beforeunload');
  rig.uncover();
  await pilot.clickConnect();
  await pilot.isReady();
  expect(await bringToEnd(rig, pilot, 1)).toBe('offered');
});

test.for(['crashes', 'is closed'])('the page %s in the middle of a write: a new tab offers to finish', async (end) => {
  const { rig, pilot } = await halfWritten();
  const { page } = pilot;
  await page.context().newPage();
  if (end === 'crashes') {
    const crashed = page.waitForEvent('crash');
    const devTools = await page.context().newCDPSession(page);
    // There is nobody left to answer.
    void devTools.send('Page.crash').catch(() => {});
    await crashed;
  }
  await page.close();
  rig.uncover();
  const next = new Pilot(await rig.open());
  await next.clickConnect();
  await next.isReady();
  expect(await bringToEnd(rig, next, 1)).toBe('offered');
});

test('a port that fails without an event is reported as lost, and is connected again when it works', async () => {
  const { rig, pilot } = await connected();
  await pilot.enter(values(1));
  await rig.breakAdapter();
  // It is still listed, so it is tried again and again.
  await pilot.sees(en.link.refused);
  await rig.mendAdapter();
  await pilot.isReady();
  expect(await pilot.shown(Object.keys(values(1)))).toEqual(values(1));
  await pilot.write();
  expect(await pilot.outcome()).toContain(en.write.verified.title);
  expect(held(rig)).toEqual(wanted(1));
});

test('a timer that answers only at 19200 baud is found, and the next time that rate is tried first', async () => {
  const { rig, pilot } = await connected({ rate: 19200 });
  await pilot.sees('firmware 536');
  expect(rig.settings?.baudRate).toBe(19200);
  await pilot.button(en.header.disconnect).click();
  await expect.poll(() => rig.sessions.closed, { timeout: 60_000 }).toBe(rig.sessions.opened);
  const { opened } = rig.sessions;
  await pilot.clickConnect();
  await pilot.isReady();
  expect(rig.sessions.opened, 'the port is opened once, at the rate that is known').toBe(opened + 1);
});
