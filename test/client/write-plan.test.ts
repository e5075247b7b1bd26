import { describe, expect, it } from 'vitest';
import {
  arePositionsKept,
  exchangedCell,
  isExplained,
  isForeign,
  isNoPositionKept,
  longestWrite,
  planWrite,
  repairRequests,
  roundedSlot,
  withRequest,
  writeParts,
} from '../../src/client/write-plan.js';
import type { TimerProgram } from '../../src/program/index.js';
import { edited } from './bench.js';

/** What the timer held: slots 0 to 3, servos 0 and 1. */
const HELD: TimerProgram = {
  identity: { timerClass: 'Q', firmware: '536', functions: 3, memories: 2, servos: 2 },
  memory: 1,
  times: [500, 1000, 2000, 9000],
  positions: [
    [10, 11, 12, 13],
    [20, 21, 22, 23],
  ],
  idleThrottle: 30,
};
const of = (changed: Partial<TimerProgram>): TimerProgram => ({ ...HELD, ...changed });

const SETTIMERS = (times: readonly number[]) => ({ name: 'SETTIMERS', times }) as const;
const SETSERVO = (servo: number, slot: number, position: number) =>
  ({ name: 'SETSERVO', function: slot, servo, position }) as const;
const SETLOWRPM = (idleThrottle: number) => ({ name: 'SETLOWRPM', idleThrottle }) as const;
const MOVETOFUNC = (slot: number) => ({ name: 'MOVETOFUNC', function: slot }) as const;

describe('the plan of a write', () => {
  it('leaves out an idle throttle that the goal does not know', () => {
    const { asked, requests } = planWrite(HELD, of({ idleThrottle: null }));
    expect([asked, requests]).toEqual([[], []]);
  });

  it.each<[before: number | null, goal: number | null, read: boolean, readBack: boolean]>([
    [30, 30, true, true],
    [30, null, true, false],
    [null, 30, true, true],
    [null, null, false, false],
  ])('reads an idle throttle of %s that is to be %s before: %s, and after: %s', (before, goal, read, readBack) => {
    const known = of({ idleThrottle: before });
    const plan = planWrite(known, of({ idleThrottle: goal }));
    expect(plan.before).toEqual({ strict: true, memory: 1, known, idleThrottle: read });
    expect(plan.after).toEqual({ strict: true, memory: 1, idleThrottle: readBack });
  });

  it('moves the servos to each function once, after the times, in the order of the functions', () => {
    const goal = edited(of({ idleThrottle: 31 }), [3, 9100], [1, 2, 99], [0, 2, 98], [0, 0, 97], [1, 0, 96]);
    const positions = [
      [SETSERVO(0, 0, 97), SETSERVO(1, 0, 96)],
      [SETSERVO(0, 2, 98), SETSERVO(1, 2, 99)],
    ] as const;
    const first = [SETTIMERS(goal.times), SETLOWRPM(31)];
    expect(planWrite(HELD, goal, true).requests).toEqual([
      ...first,
      MOVETOFUNC(0),
      ...positions[0],
      MOVETOFUNC(2),
      ...positions[1],
    ]);
    expect(planWrite(HELD, goal).requests).toEqual([
      SETTIMERS(goal.times),
      SETSERVO(0, 0, 97),
      SETSERVO(0, 2, 98),
      SETSERVO(1, 0, 96),
      SETSERVO(1, 2, 99),
      SETLOWRPM(31),
    ]);
  });

  it('has three parts: a reading to compare with what is known, the write, and two readings back', () => {
    const content = ['GETTIMERS', 'GETSERVOPOS', 'GETLOWRPM'];
    expect(writeParts(planWrite(HELD, edited(HELD, [3, 9100])))).toEqual([
      { stage: 'read', names: ['GETSWVER', 'GETMEMORY', ...content, 'GETMEMORY', 'GETSWVER'] },
      { stage: 'write', names: ['SETTIMERS'] },
      { stage: 'verify', names: ['GETSWVER', 'GETMEMORY', ...content, ...content, 'GETMEMORY', 'GETSWVER'] },
    ]);
  });

  it.each<[number | null, string[]]>([
    [30, ['SETLOWRPM']],
    [null, []],
  ])('is longest when every value changes, with an idle throttle of %s', (idleThrottle, names) => {
    const cells = Array<string>(8).fill('SETSERVO');
    const [, write] = longestWrite(of({ idleThrottle }), false);
    expect(write).toEqual({ stage: 'write', names: ['SETTIMERS', ...cells, ...names] });
    const [, moved] = longestWrite(of({ idleThrottle }), true);
    const byFunction = Array.from({ length: 4 }, () => ['MOVETOFUNC', 'SETSERVO', 'SETSERVO']).flat();
    expect(moved).toEqual({ stage: 'write', names: ['SETTIMERS', ...names, ...byFunction] });
  });
});

it('the longest write reads no idle throttle that is not known to be there when the goal knows none', () => {
  const identity = { ...HELD.identity, timerClass: 'B' };
  const [read] = longestWrite(of({ identity, idleThrottle: null }), false);
  expect(read?.names).not.toContain('GETLOWRPM');
  expect(longestWrite(of({ identity }), false)[0]?.names).toContain('GETLOWRPM');
});

describe('what an accepted request makes of a program', () => {
  it.each([
    ['all times', SETTIMERS([1, 2, 3, 4]), of({ times: [1, 2, 3, 4] })],
    ['one position', SETSERVO(1, 2, 99), edited(HELD, [1, 2, 99])],
    ['the idle throttle', SETLOWRPM(31), of({ idleThrottle: 31 })],
    ['nothing', MOVETOFUNC(1), HELD],
  ])('%s', (_, request, after) => {
    expect(withRequest(HELD, request, null)).toEqual(after);
  });

  it('the times come from the acknowledgement: the timer may have rounded them', () => {
    expect(withRequest(HELD, SETTIMERS([1, 2, 3, 4]), [0, 2, 3, 4]).times).toEqual([0, 2, 3, 4]);
  });
});

describe('whether this write explains what the timer holds', () => {
  const goal = edited(HELD, [1, 1200], [0, 2, 99]);
  const plan = planWrite(HELD, goal);
  const onlyPositions = planWrite(HELD, edited(HELD, [0, 2, 99]));

  it.each<[string, TimerProgram, boolean]>([
    ['all as it was', HELD, true],
    ['all as wanted', goal, true],
    ['a time that was rounded by less than a second', edited(goal, [1, 1101]), true],
    ['a time that is a second off', edited(goal, [1, 1100]), false],
    ['a time that is a second off the other way', edited(goal, [1, 1300]), false],
    ['the position at the cell with servo and function exchanged', edited(HELD, [1, 0, 20], [0, 2, 12]), true],
    ['a position that nobody sent', edited(goal, [1, 3, 1]), false],
    ['a position close to the one that was sent', edited(goal, [0, 2, 98]), false],
    ['another idle throttle', { ...goal, idleThrottle: 31 }, false],
    ['an idle throttle that was not read', { ...goal, idleThrottle: null }, true],
  ])('%s: on a good line', (_, held, isIt) => {
    expect(isExplained(plan, held, false)).toBe(isIt);
  });

  it('does not call it rounding when no time was sent', () => {
    expect(isExplained(onlyPositions, edited(HELD, [1, 1001]), false)).toBe(false);
  });

  it('does not ask for an idle throttle that the goal does not know', () => {
    const unknown = planWrite(of({ idleThrottle: null }), of({ idleThrottle: null, times: goal.times }));
    expect(isExplained(unknown, of({ idleThrottle: 31 }), false)).toBe(true);
  });

  it('on a damaged line each request may have disturbed one value, and no more', () => {
    const one = edited(HELD, [1, 3, 1]);
    const two = edited(one, [1, 2, 2]);
    expect([one, two].map((held) => isExplained(onlyPositions, held, true))).toEqual([true, false]);
    expect(isExplained(onlyPositions, one, false)).toBe(false);
  });
});

describe('whether something else has changed the timer', () => {
  const goal = edited(HELD, [0, 2, 99]);
  const plan = planWrite(HELD, goal);
  const stray = [1, 3, 1] as [number, number, number];

  it.each<[string, TimerProgram, boolean, boolean]>([
    ['all is as wanted', goal, false, false],
    ['the value did not take', HELD, false, false],
    ['one other value changed, and the value took', edited(goal, stray), false, false],
    ['one other value changed, and the value did not take', edited(HELD, stray), true, false],
    ['one other time changed, and the value did not take', edited(HELD, [1, 1]), true, false],
    ['more changed than was sent', edited(goal, stray, [1, 2, 2]), true, true],
    ['several times changed, which one request may have disturbed', edited(goal, [1, 1], [2, 2]), false, false],
    ['a time and a position changed', edited(goal, [1, 1], stray), true, true],
  ])('%s', (_, held, onGoodLine, onDamagedLine) => {
    expect([isForeign(plan, held, false), isForeign(plan, held, true)]).toEqual([onGoodLine, onDamagedLine]);
  });

  it('no, when the other value is the one with servo and function exchanged', () => {
    // 99 for servo 0, function 1, went to servo 1, function 0.
    const sent = planWrite(HELD, edited(HELD, [0, 1, 99]));
    expect(isForeign(sent, edited(HELD, [1, 0, 99]), false)).toBe(false);
    expect(isForeign(sent, edited(HELD, [1, 0, 98]), false)).toBe(true);
  });

  it('no, when the two cells have changed places', () => {
    const sent = planWrite(HELD, edited(HELD, [1, 1200], [0, 1, 99]));
    const held = edited(HELD, [1, 1200], [2, 2100], [1, 0, 99]);
    expect(isForeign(sent, held, false)).toBe(false);
  });

  it('yes, also when only some of the requests were not stored', () => {
    const two = planWrite(HELD, edited(HELD, [0, 2, 99], [0, 3, 98]));
    expect(isForeign(two, edited(HELD, [0, 3, 98], stray), false)).toBe(true);
    expect(isForeign(two, edited(HELD, [0, 2, 99], [0, 3, 98], stray), false)).toBe(false);
  });

  it('moving the servos does not count as a request that may disturb a value', () => {
    const moving = planWrite(HELD, goal, true);
    expect(moving.requests).toHaveLength(2);
    expect(isForeign(moving, edited(goal, stray, [1, 2, 2]), false)).toBe(true);
  });
});

describe('what the positions that were read back say of the timer', () => {
  const goal = edited(HELD, [1, 1200], [0, 2, 99], [1, 2, 98]);
  const apart = edited(HELD, [1, 1200], [0, 2, 99], [1, 3, 98]);

  it('it kept none when all are as they were', () => {
    const plan = planWrite(HELD, goal);
    expect(isNoPositionKept(plan, edited(HELD, [1, 1200]))).toBe(true);
    expect(isNoPositionKept(plan, edited(HELD, [0, 2, 99]))).toBe(false);
    expect(isNoPositionKept(plan, edited(HELD, [0, 2, 98], [1, 2, 97]))).toBe(false);
    expect(isNoPositionKept(planWrite(HELD, edited(HELD, [1, 1200])), HELD)).toBe(false);
  });

  it('it keeps them where the servos do not stand only when those of two functions were stored', () => {
    expect(arePositionsKept(planWrite(HELD, apart), apart)).toBe(true);
    expect(arePositionsKept(planWrite(HELD, goal), goal), 'both positions belong to one function').toBe(false);
    expect(
      arePositionsKept(planWrite(HELD, apart), edited(HELD, [1, 1200], [0, 2, 99])),
      'the timer took only one of the two positions',
    ).toBe(false);
    expect(
      arePositionsKept(planWrite(HELD, edited(HELD, [1, 1200], [2, 2100])), HELD),
      'none of the kept positions was to be changed',
    ).toBe(false);
    const withTimes = edited(HELD, [1, 1200], [0, 2, 99]);
    expect(arePositionsKept(planWrite(HELD, withTimes), withTimes), 'a kept time is not a kept position').toBe(false);
  });

  it('it takes the servo first when a cell holds what was sent for the one with servo and function exchanged', () => {
    const plan = planWrite(HELD, edited(HELD, [1, 1200], [0, 1, 99]));
    expect(exchangedCell(plan, edited(HELD, [2, 99], [1, 0, 99]))).toEqual({ kind: 'position', servo: 1, slot: 0 });
    expect(exchangedCell(plan, edited(HELD, [1, 0, 98])), 'the cell holds another value than was sent').toBeNull();
    expect(exchangedCell(plan, edited(HELD, [1, 1, 99])), 'the cell belongs to another function').toBeNull();
    expect(exchangedCell(plan, edited(HELD, [0, 0, 99])), 'the cell belongs to another servo').toBeNull();
  });

  it('the first slot whose time it has rounded is found by the acknowledgement and the reading back', () => {
    const plan = planWrite(HELD, edited(HELD, [0, 505], [1, 1205]));
    const held = edited(HELD, [0, 500], [1, 1200]);
    expect(roundedSlot(plan, held.times, held)).toBe(0);
    expect(
      roundedSlot(plan, plan.goal.times, held),
      'the acknowledgement gives the times as they were sent',
    ).toBeNull();
    expect(roundedSlot(plan, null, held), 'there was no acknowledgement').toBeNull();
    expect(roundedSlot(plan, [505, 1200, 2000, 9000], edited(held, [0, 505]))).toBe(1);
  });
});

describe('what is sent after the reading back', () => {
  const goal = edited(HELD, [1, 1200], [0, 2, 99]);
  const plan = planWrite(HELD, goal);

  it.each<[string, TimerProgram, unknown[]]>([
    ['a time', edited(goal, [2, 1]), [SETTIMERS(goal.times)]],
    ['a position', edited(goal, [1, 3, 1]), [SETSERVO(1, 3, 23)]],
    ['the idle throttle', { ...goal, idleThrottle: 31 }, [SETLOWRPM(30)]],
    ['nothing', goal, []],
  ])('%s that changed without being asked is put back', (_, held, requests) => {
    expect(repairRequests(plan, held, false, false)).toEqual({ requests, quirks: {} });
  });

  it('what was not stored is sent again only where damage was seen', () => {
    const held = of({ idleThrottle: 31 });
    const asked = planWrite(HELD, { ...goal, idleThrottle: 32 });
    expect(repairRequests(asked, held, false, false).requests).toEqual([]);
    expect(repairRequests(asked, held, true, false).requests).toEqual([
      SETTIMERS(goal.times),
      SETSERVO(0, 2, 99),
      SETLOWRPM(32),
    ]);
  });

  it('what changed without being asked is put back alone when something else was not stored', () => {
    const asked = planWrite(HELD, { ...goal, idleThrottle: 32 });
    const held = edited(HELD, [1, 3, 1]);
    expect(repairRequests(asked, held, false, false).requests).toEqual([SETSERVO(1, 3, 23)]);
  });

  it('the largest position that can be set is put back, and a larger one is not', () => {
    for (const [position, requests] of [
      [130, [SETSERVO(1, 3, 130)]],
      [131, []],
    ] as const) {
      const before = edited(HELD, [1, 3, position]);
      const sent = planWrite(before, edited(before, [1, 1200]));
      expect(repairRequests(sent, edited(before, [1, 1200], [1, 3, 7]), false, false).requests).toEqual(requests);
    }
  });

  it.each([false, true])('a wrong cell is put back in the other order, where the servo was first: %s', (servoFirst) => {
    const sent = planWrite(HELD, edited(HELD, [0, 1, 99]), true);
    const held = edited(HELD, [2, 1], [1, 0, 99]);
    expect(repairRequests(sent, held, false, servoFirst)).toEqual({
      requests: [MOVETOFUNC(0), SETSERVO(1, 0, 20)],
      quirks: { servoFirst: !servoFirst },
    });
  });
});
