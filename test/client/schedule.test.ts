import { describe, expect, it } from 'vitest';
import { LearnedTiming } from '../../src/client/line-timing.js';
import { exchangesOf, longestExchanges } from '../../src/client/retry-policy.js';
import { type PlannedJob, Schedule } from '../../src/client/schedule.js';
import { VirtualClock } from '../../src/line/index.js';
import type { Identity } from '../../src/protocol/index.js';

const identity: Identity = { timerClass: 'B', firmware: '536', functions: 10, memories: 4, servos: 3 };
/** One byte takes one millisecond. */
const timing = { baudRate: 10_000, margin: 600 };

function begun(parts: PlannedJob['parts'], known: Identity | null = identity) {
  const clock = new VirtualClock(1000);
  const schedule = new Schedule(clock, new LearnedTiming(timing));
  const told: string[] = [];
  schedule.begin({
    parts,
    identity: known,
    onProgress: ({ stage, done, total, fraction, memory, repeats }) =>
      told.push(`${stage} ${done}/${total} ${fraction.toFixed(2)} M${memory} ${repeats}`),
  });
  return { clock, schedule, told };
}

// GETSWVER has 27 bytes with its reply, GETMEMORY and SETLOWRPM have 19.
const PARTS: PlannedJob['parts'] = [
  { stage: 'read', names: ['GETSWVER', 'GETMEMORY'] },
  { stage: 'write', names: ['SETLOWRPM'] },
  { stage: 'verify', names: ['GETMEMORY'] },
];

describe('how far a job is', () => {
  it('is reported in bytes, with each stage and each answer', () => {
    const { schedule, told } = begun(PARTS);
    schedule.enter('read');
    schedule.answered('GETSWVER');
    schedule.answered('GETMEMORY');
    schedule.enter('write');
    schedule.answered('SETLOWRPM');
    schedule.enter('verify');
    schedule.answered('GETMEMORY');
    expect(told).toEqual([
      'read 0/84 0.00 Mnull 0',
      'read 27/84 0.32 Mnull 0',
      'read 46/84 0.55 Mnull 0',
      'write 46/84 0.55 Mnull 0',
      'write 65/84 0.77 Mnull 0',
      'verify 65/84 0.77 Mnull 0',
      'verify 84/84 1.00 Mnull 0',
    ]);
  });

  it('does not move with what was not planned, but moves with what is skipped', () => {
    const { schedule, told } = begun(PARTS);
    schedule.enter('read');
    schedule.answered('GETSWVER');
    schedule.answered('GETSWVER');
    schedule.repeated();
    schedule.enter('write');
    schedule.enter('repair');
    schedule.enter('read');
    schedule.answered('GETMEMORY');
    schedule.enter('verify');
    expect(told).toEqual([
      'read 0/84 0.00 Mnull 0',
      'read 27/84 0.32 Mnull 0',
      'read 27/84 0.32 Mnull 0',
      'read 27/84 0.32 Mnull 1',
      'write 46/84 0.55 Mnull 1',
      'repair 46/84 0.55 Mnull 1',
      'read 46/84 0.55 Mnull 1',
      'read 46/84 0.55 Mnull 1',
      'verify 65/84 0.77 Mnull 1',
    ]);
  });

  it('counts the stages of each memory separately, and the parts without one at both ends', () => {
    const { schedule, told } = begun([
      { names: ['GETSWVER'] },
      { stage: 'read', memory: 0, names: ['GETMEMORY'] },
      { stage: 'read', memory: 2, names: ['GETMEMORY'] },
      { names: ['GETSWVER'] },
    ]);
    schedule.answered('GETSWVER');
    schedule.memory = 0;
    schedule.enter('read');
    schedule.answered('GETMEMORY');
    schedule.memory = 2;
    schedule.enter('read');
    schedule.answered('GETMEMORY');
    schedule.answered('GETSWVER');
    schedule.answered('GETSWVER');
    expect(told).toEqual([
      'read 27/92 0.29 M0 0',
      'read 46/92 0.50 M0 0',
      'read 46/92 0.50 M2 0',
      'read 65/92 0.71 M2 0',
      'read 92/92 1.00 M2 0',
      'read 92/92 1.00 M2 0',
    ]);
  });

  it('begins no later part before the present one is done or its stage is reported', () => {
    const { schedule, told } = begun([
      { stage: 'read', names: ['GETSWVER', 'GETMEMORY'] },
      { stage: 'verify', names: ['GETSWVER'] },
      { names: ['GETSWVER'] },
    ]);
    schedule.enter('read');
    for (const name of ['GETSWVER', 'GETSWVER', 'GETMEMORY', 'GETSWVER'] as const) schedule.answered(name);
    schedule.enter('verify');
    for (const name of ['GETMEMORY', 'GETSWVER', 'GETSWVER'] as const) schedule.answered(name);
    expect(told.map((text) => text.split('/')[0])).toEqual([
      'read 0',
      'read 27',
      'read 27',
      'read 46',
      'read 46',
      'verify 46',
      'verify 46',
      'verify 73',
      'verify 100',
    ]);
  });

  it('finds the next part of a stage that comes twice, and stays at the one that has begun', () => {
    const { schedule, told } = begun([
      { stage: 'read', names: ['GETSWVER'] },
      { stage: 'write', names: ['SETLOWRPM'] },
      { stage: 'read', names: ['GETMEMORY'] },
    ]);
    for (const stage of ['read', 'read', 'write', 'read'] as const) schedule.enter(stage);
    expect(told.map((text) => text.split('/')[0])).toEqual(['read 0', 'read 0', 'write 27', 'read 46']);
  });

  it('goes step by step through a part without a stage, too', () => {
    const { schedule, told } = begun([{ stage: 'read', names: ['GETMEMORY'] }, { names: ['GETSWVER', 'GETMEMORY'] }]);
    schedule.enter('read');
    for (const name of ['GETMEMORY', 'GETMEMORY', 'GETSWVER'] as const) schedule.answered(name);
    expect(told.map((text) => text.split('/')[0])).toEqual(['read 0', 'read 19', 'read 38', 'read 65']);
  });

  it('is nothing before the timer is known, and everything when there is nothing to ask', () => {
    for (const [known, text] of [
      [null, 'read 0/0 0.00 Mnull 0'],
      [identity, 'read 0/0 1.00 Mnull 0'],
    ] as const) {
      const { schedule, told } = begun([], known);
      schedule.enter('read');
      expect(told).toEqual([text]);
    }
    const { schedule, told } = begun(PARTS, null);
    schedule.enter('read');
    expect(told).toEqual(['read 0/0 0.00 Mnull 0']);
  });

  it('begins anew with each job; repeats are counted on', () => {
    const { schedule, told } = begun(PARTS);
    schedule.enter('write');
    schedule.repeated();
    schedule.begin({ parts: PARTS, identity, onProgress: ({ stage, done }) => told.push(`again: ${stage} ${done}`) });
    expect(schedule.repeats).toBe(1);
    schedule.enter('read');
    schedule.repeated();
    expect([told.at(-1), schedule.repeats]).toEqual(['again: read 0', 2]);
  });
});

describe('the time of a job', () => {
  const whole =
    2 * longestExchanges(exchangesOf(['GETSWVER', 'GETMEMORY', 'SETLOWRPM', 'GETMEMORY'], identity), timing);
  const kept = 2 * longestExchanges(exchangesOf(['GETMEMORY'], identity), timing) + 15_000;

  it('is twice the longest time of its exchanges, and some more for damage', () => {
    expect(begun(PARTS).schedule.endsBy).toBe(1000 + whole + 45_000);
  });

  it('is enough for what ends in it, and not for more', async () => {
    const { clock, schedule } = begun(PARTS);
    const left = whole + 45_000;
    expect([schedule.hasTimeFor(left), schedule.hasTimeFor(left + 1)]).toEqual([true, false]);
    await clock.advance(500);
    expect([schedule.hasTimeFor(left - 500), schedule.hasTimeFor(left - 499)]).toEqual([true, false]);
  });

  it('is kept for what has to be done at the end, until that begins', async () => {
    const { schedule } = begun(PARTS);
    const left = whole + 45_000;
    await schedule.keepTimeFor(['GETMEMORY'], async () => {
      expect([schedule.hasTimeFor(left - kept), schedule.hasTimeFor(left - kept + 1)]).toEqual([true, false]);
    });
    expect(schedule.hasTimeFor(left)).toBe(true);
    const failed = schedule.keepTimeFor(['GETMEMORY'], () => Promise.reject(new Error('failed')));
    await expect(failed).rejects.toThrow('failed');
    expect(schedule.hasTimeFor(left), 'no time is reserved any more, also after the work failed').toBe(true);
  });

  it('grows by the time that is spent on other things than the line', async () => {
    const { clock, schedule } = begun(PARTS);
    const before = schedule.endsBy;
    await clock.run(schedule.waitFor(() => new Promise<void>((resolve) => void clock.after(700, resolve))));
    expect(schedule.endsBy - before).toBe(700);
  });
});
