import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { connected } from './pilot.js';

const identity = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 } as const;

test('M3 in the table leaves the timer as it was, and what flies next is what the pilot was told', async () => {
  const { rig, pilot } = await connected({ timer: { identity } });
  const { core } = rig.timer;
  const before = structuredClone(core.memories);
  const selected = (): number[] =>
    core.answered.flatMap((request) => (request.name === 'SETMEMORY' ? [request.memory] : []));
  const look = async (name: string): Promise<void> => {
    await pilot.page.getByRole('radio', { name, exact: true }).check({ force: true });
  };

  await look('M3');
  await pilot.button(en.look.edit({ memory: 'M3' })).click();
  await pilot.sees(`${en.nextFlight.onScreen({ memory: 'M3' })} ${en.nextFlight.other({ memory: 'M1' })}`);
  expect([core.memory, selected(), core.memories]).toEqual([0, [2, 0], before]);

  await pilot.goTo('Memories');
  await pilot.button(en.look.fly({ memory: 'M3' })).click();
  await pilot.sees(`${en.nextFlight.other({ memory: 'M3' })} ${en.nextFlight.original({ original: 'M1' })}`);
  expect(core.memory).toBe(2);
  await pilot.button(en.header.disconnect).click();
  await expect.poll(() => rig.sessions, { timeout: 60_000 }).toEqual({ opened: 1, closed: 1 });
  expect([core.memory, selected(), core.memories]).toEqual([2, [2, 0, 2], before]);
});

test('M3 is written from the table, and the timer is left at M1', async () => {
  const { rig, pilot } = await connected({ timer: { identity } });
  const { core } = rig.timer;
  const [m1] = structuredClone(core.memories);
  await pilot.page.getByRole('radio', { name: 'M3', exact: true }).check({ force: true });
  await pilot.button(en.look.edit({ memory: 'M3' })).click();
  await pilot.sees(`${en.nextFlight.onScreen({ memory: 'M3' })} ${en.nextFlight.other({ memory: 'M1' })}`);
  await pilot.type('DT time', '2:30');
  await pilot.prepare();
  await pilot.startWriting();
  await pilot.sees(en.write.verified.title);
  expect([core.memory, core.memories[0], core.memories[2]?.times[10]]).toEqual([0, m1, 15_000]);
});
