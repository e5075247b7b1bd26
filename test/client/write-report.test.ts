import { describe, expect, it } from 'vitest';
import { isHeld, unasked, verdict } from '../../src/client/write-report.js';
import { differences, type TimerProgram } from '../../src/program/index.js';
import { edited } from './bench.js';

const GOAL: TimerProgram = {
  identity: { timerClass: 'Q', firmware: '536', functions: 1, memories: 2, servos: 1 },
  memory: 0,
  times: [500, 9000],
  positions: [[10, 11]],
  idleThrottle: 30,
};
const noThrottle = { ...GOAL, idleThrottle: null };

it.each<[string, TimerProgram, TimerProgram, boolean]>([
  ['all of it', GOAL, GOAL, true],
  ['another time', GOAL, edited(GOAL, [1, 9001]), false],
  ['an idle throttle that was not known', noThrottle, GOAL, true],
  ['an idle throttle that was not known, and another position', noThrottle, edited(GOAL, [0, 0, 9]), false],
  ['an idle throttle that is not known any more', GOAL, noThrottle, false],
])('whether a memory holds what was expected: %s', (_, believed, held, isIt) => {
  expect(isHeld(believed, held)).toBe(isIt);
});

describe('values that nobody asked to change', () => {
  const asked = differences(GOAL, edited(GOAL, [1, 8000]));

  it('are those that are not as wanted, except the ones that were asked for', () => {
    const held = edited(GOAL, [1, 7000], [0, 1, 12]);
    expect(unasked(held, GOAL, asked).map(({ field }) => field)).toEqual([{ kind: 'position', servo: 0, slot: 1 }]);
  });

  it('do not include what the goal does not know', () => {
    expect(unasked(GOAL, noThrottle, [])).toEqual([]);
  });
});

describe('the verdict', () => {
  const time = { kind: 'time', slot: 1 } as const;
  const throttle = { kind: 'idleThrottle' } as const;
  const asked = [
    { field: time, from: 1, to: 9000 },
    { field: throttle, from: 1, to: 30 },
  ];

  it.each<[string, TimerProgram | null, string, string[]]>([
    ['verified when all that was asked for is held', GOAL, 'verified', ['verified', 'verified']],
    ['that it differs when one value does', edited(GOAL, [1, 1]), 'differs', ['differs', 'verified']],
    ['unknown when one value was not read', noThrottle, 'unknown', ['verified', 'unknown']],
    [
      'that it differs when one value does and one was not read',
      edited(noThrottle, [1, 1]),
      'differs',
      ['differs', 'unknown'],
    ],
    ['unknown when nothing was read', null, 'unknown', ['unknown', 'unknown']],
  ])('is %s', (_, held, result, statuses) => {
    const report = verdict(GOAL, asked, [], held);
    expect([report.result, report.values.map(({ status }) => status)]).toEqual([result, statuses]);
  });

  it('needs a reading even when there was nothing to change', () => {
    expect([verdict(GOAL, [], [], null).result, verdict(GOAL, [], [], GOAL).result]).toEqual(['unknown', 'verified']);
  });

  it('names first what was asked for, then what else has changed', () => {
    expect(verdict(GOAL, asked.slice(0, 1), [throttle], { ...GOAL, idleThrottle: 31 })).toEqual({
      result: 'differs',
      asked: 1,
      values: [
        { field: time, wanted: 9000, held: 9000, status: 'verified', asked: true },
        { field: throttle, wanted: 30, held: 31, status: 'differs', asked: false },
      ],
    });
  });
});
