import { describe, expect, it } from 'vitest';
import type { Progress, TimerClient } from '../../src/client/index.js';
import { type Bench, bench, memoryOf } from './bench.js';
import { everyValueChanged } from './matrix.js';

type OnProgress = { readonly onProgress: (progress: Progress) => void };

/** What a job has told of its way, and the bytes that went over the line for it. */
async function way({ client, run, line }: Bench, job: (told: OnProgress) => Promise<unknown>) {
  await run(client.identify());
  line.length = 0;
  const told: Progress[] = [];
  await run(job({ onProgress: (progress) => told.push(progress) }));
  const bytes = line.reduce((sum, entry) => sum + entry.bytes.length, 0);
  return { first: told[0], last: told.at(-1), bytes };
}

const goal = (timer: Bench['timer'], memory: number, idleThrottle: number | null) => ({
  ...everyValueChanged(memoryOf(timer, memory)),
  idleThrottle,
});

it.each<[string, (client: TimerClient, timer: Bench['timer'], told: OnProgress) => Promise<unknown>]>([
  ['a reading', (client, _, told) => client.readProgram(told)],
  ['a reading with the idle throttle', (client, _, told) => client.readProgram({ ...told, idleThrottle: true })],
  ['a reading of other memories', (client, _, told) => client.readMemories({ ...told, memories: [1, 3] })],
  [
    'a reading of other memories with the idle throttle',
    (client, _, told) => client.readMemories({ ...told, memories: [1, 3], idleThrottle: true }),
  ],
  [
    'a write of all values into another memory',
    (client, timer, told) => client.writeMemories([goal(timer, 2, null)], told),
  ],
  [
    'a write of all values that moves the servos',
    (client, timer, told) => client.writeMemories([goal(timer, 2, null)], { ...told, moveServos: true }),
  ],
  [
    'a write into the memory that flies next that moves the servos',
    (client, timer, told) =>
      client.writeProgram(goal(timer, 0, null), { ...told, baseline: memoryOf(timer, 0), moveServos: true }),
  ],
  [
    'a write of all values into another memory with the idle throttle',
    (client, timer, told) => client.writeMemories([goal(timer, 2, 77)], told),
  ],
])('the plan of a job on a good line has exactly the requests that are sent: %s', async (_, job) => {
  const own = bench();
  const { first, last, bytes } = await way(own, (told) => job(own.client, own.timer, told));
  expect({ total: first?.total, done: last?.done }).toEqual({ total: bytes, done: bytes });
});

describe('the time of a job', () => {
  // A line so slow that a fence takes most of the 45 seconds which each job may lose.
  const slow = () =>
    bench({ fromTimer: { fault: (byte) => [byte === 0x6c || byte === 0x72 ? 1 : byte] } }, { baudRate: 300 });

  it('is enough for its requests before the timer is known', async () => {
    const { client, run } = slow();
    await expect(run(client.identify())).rejects.toMatchObject({ code: 'unstable', details: { sent: 4 } });
  });

  it.each<[string, number, (client: TimerClient) => Promise<unknown>]>([
    ['a request once the timer is known', 0x72, (client) => client.request({ name: 'GETMEMORY' })],
    ['the setting of the idle throttle', 0x6c, (client) => client.setIdleThrottle(77)],
  ])('is enough for %s', async (_, letter, job) => {
    let isDamaged = false;
    const fault = (byte: number): number[] => [isDamaged && byte === letter ? 1 : byte];
    const { client, run } = bench({ fromTimer: { fault } }, { baudRate: 300 });
    await run(client.identify());
    isDamaged = true;
    await expect(run(job(client))).rejects.toMatchObject({ details: { sent: 20 } });
  });
});
