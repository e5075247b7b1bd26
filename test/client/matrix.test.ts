import { describe, expect, it } from 'vitest';
import { shareOf } from '../tools/share.js';
import { allCases, holds, wentOutOnce } from './matrix.js';

const SMALL = { functions: 2, memories: 2, servos: 1 };

describe('every fault at every byte of either direction, with a small timer', () => {
  it.each([
    ['connect', 'B', 297],
    ['connect', 'Q', 297],
    ['read', 'B', 1210],
    ['read', 'Q', 1419],
  ] as const)('%s, class %s: %i cases; the goal is reached afterwards', async (act, timerClass, count) => {
    const cases = await allCases({ ...SMALL, timerClass }, act);
    expect(cases).toHaveLength(count);
    for (const hit of shareOf(cases)) await holds(hit, 'goal');
  });

  it.each([
    ['B', 4532],
    ['Q', 5368],
  ] as const)(
    'write of every value, class %s: afterwards a write reaches the goal, or what was before; %i cases',
    async (timerClass, count) => {
      const cases = await allCases({ ...SMALL, timerClass }, 'write');
      expect(cases).toHaveLength(count);
      // The two aims by turns, and the other way round at the next byte: 11 faults befall each.
      const aimed = cases.map((hit, index) => ({
        hit,
        aim: index % 2 === 0 ? ('goal' as const) : ('before' as const),
      }));
      for (const { hit, aim } of shareOf(aimed)) await holds(hit, aim);
    },
  );

  it.each([
    ['UNLOCK', 198],
    ['JUMP2', 198],
    ['MOVETOFUNC', 209],
  ] as const)('%s goes out once and is carried out once at most: %i cases', async (act, count) => {
    const cases = await allCases({ ...SMALL, timerClass: 'Q' }, act);
    expect(cases).toHaveLength(count);
    for (const hit of shareOf(cases)) await wentOutOnce(hit);
  });
});
