import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { fieldKey, fieldsOf, partWritten, type TimerProgram, valueAt, withValue } from '../../src/program/index.js';
import { SMALL } from '../protocol/vectors.js';

const BEFORE: TimerProgram = {
  identity: { ...SMALL, functions: 2, timerClass: 'Q' },
  memory: 0,
  times: [100, 200, 300],
  positions: [[1, 2, 3]],
  idleThrottle: 30,
};
const GOAL: TimerProgram = { ...BEFORE, times: [100, 250, 300], positions: [[1, 22, 33]] };

function told(held: TimerProgram, goal = GOAL): unknown {
  const { extent, written, missing, foreign } = partWritten(BEFORE, goal, held);
  const keys = (changes: typeof written): string[] => changes.map(({ field }) => fieldKey(field));
  return [extent, keys(written), keys(missing), keys(foreign)];
}

describe('an interrupted write', () => {
  it.each<[string, TimerProgram, unknown]>([
    ['nothing of it', BEFORE, ['nothing', [], ['time:1', 'position:0:1', 'position:0:2'], []]],
    ['the times of it', { ...BEFORE, times: GOAL.times }, ['part', ['time:1'], ['position:0:1', 'position:0:2'], []]],
    ['all of it', GOAL, ['all', ['time:1', 'position:0:1', 'position:0:2'], [], []]],
    [
      'something else in a place that it was to change',
      { ...GOAL, positions: [[1, 22, 34]] },
      ['foreign', ['time:1', 'position:0:1'], [], ['position:0:2']],
    ],
    [
      'something else in a place that it was not to change',
      { ...GOAL, idleThrottle: 31 },
      ['foreign', ['time:1', 'position:0:1', 'position:0:2'], [], ['idleThrottle']],
    ],
  ])('left %s', (_, held, expected) => {
    expect(told(held)).toEqual(expected);
  });

  it('may lack the idle throttle on either side', () => {
    expect(told({ ...GOAL, idleThrottle: null })).toMatchObject({ 0: 'all' });
    expect(told(GOAL, { ...GOAL, idleThrottle: null })).toMatchObject({ 0: 'all' });
    expect(partWritten({ ...BEFORE, idleThrottle: null }, GOAL, { ...GOAL, idleThrottle: 31 }).foreign).toEqual([]);
  });

  it('is explained by every mixture of old and new values, and by nothing else', () => {
    const fields = fieldsOf(BEFORE.identity);
    const value = fc.integer({ min: 0, max: 3 });
    const program = fc
      .array(value, { minLength: fields.length, maxLength: fields.length })
      .map((values) => fields.reduce((p, field, i) => withValue(p, field, values[i] as number), BEFORE));
    fc.assert(
      fc.property(program, program, program, (before, goal, held) => {
        const { extent, written, missing, foreign } = partWritten(before, goal, held);
        const at = (p: TimerProgram) => fields.map((field) => valueAt(p, field) as number);
        const [b, g, h] = [at(before), at(goal), at(held)];
        const explained = h.every((v, i) => v === b[i] || v === g[i]);
        expect(extent === 'foreign').toBe(!explained);
        const isGoal = h.every((v, i) => v === g[i]);
        expect(extent === 'all').toBe(isGoal);
        expect(written.length + missing.length + foreign.length).toBe(
          fields.filter((_, i) => b[i] !== g[i] || (h[i] !== b[i] && h[i] !== g[i])).length,
        );
      }),
      { numRuns: 2000 },
    );
  });
});
