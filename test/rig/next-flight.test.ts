import { expect, test } from 'vitest';
import { en } from '../../src/app/messages/en.js';
import { connected } from './pilot.js';

const identity = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 } as const;

test('a look leaves the timer as it was, and what flies next is what the pilot was told', async () => {
  const { rig, pilot } = await connected({ timer: { identity } });
  const { core } = rig.timer;
  const before = structuredClone(core.memories);
  const selected = (): number[] =>
    core.answered.flatMap((request) => (request.name === 'SETMEMORY' ? [request.memory] : []));
  const look = async (name: string): Promise<void> => {
    await pilot.page.getByRole('radio', { name, exact: true }).check({ force: true });
  };

  await look('M3');
  await pilot.button(en.look.look('M3')).click();
  await pilot.page.getByRole('heading', { name: /^M3, read / }).waitFor();
  expect([core.memory, selected(), core.memories]).toEqual([0, [2, 0], before]);

  await pilot.button(en.look.fly('M3')).click();
  await pilot.sees(`${en.nextFlight.other('M3')} ${en.nextFlight.original('M1')}`);
  expect(core.memory).toBe(2);
  await pilot.button(en.header.disconnect).click();
  await expect.poll(() => rig.sessions, { timeout: 60_000 }).toEqual({ opened: 1, closed: 1 });
  expect([core.memory, selected(), core.memories]).toEqual([2, [2, 0, 2], before]);
});
