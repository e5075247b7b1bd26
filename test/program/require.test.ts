import { describe, expect, it } from 'vitest';
import { requireShape, type TimerProgram } from '../../src/program/index.js';
import { entries } from '../../src/program/library.js';
import { flag, id, list, measured, record, text, whole, wholes, within, word } from '../../src/program/require.js';
import { refusalOf } from './refusal.js';

const SMALL = { timerClass: 'B', firmware: '536', functions: 1, memories: 1, servos: 1 };
const program = (other: Partial<TimerProgram>): TimerProgram => ({
  identity: SMALL,
  memory: 0,
  times: [0, 1],
  positions: [[0, 1]],
  idleThrottle: null,
  ...other,
});

const LONG_ID = 'a'.repeat(65);
const TWICE = [{ id: 'a' }, { id: 'a' }];
const ONE_OF_TWO = { value: 1, min: 2, max: 2 };

describe('a value from outside is refused with its place, what it must be, and its limits', () => {
  it.each<[string, object, () => unknown]>([
    ['wrong-type p must be an object', { value: 5 }, () => record(5, 'p')],
    ['wrong-type p must be an object', { value: null }, () => record(null, 'p')],
    ['wrong-type p must be an object', { value: [] }, () => record([], 'p')],
    ['wrong-type p must be a list', { value: {} }, () => list({}, 'p', 1)],
    ['wrong-count p must have at most 1 entries', { value: 2, max: 1 }, () => list([1, 2], 'p', 1)],
    ['wrong-type p must be a text', { value: 5 }, () => text(5, 'p', 3)],
    ['out-of-range p must have 1 to 3 characters', { value: 4, min: 1, max: 3 }, () => text('abcd', 'p', 3, 1)],
    ['out-of-range p must have 1 to 3 characters', { value: 0, min: 1, max: 3 }, () => text('', 'p', 3, 1)],
    // Too long to be gone through.
    ['out-of-range p must have 0 to 3 characters', { value: 8, min: 0, max: 3 }, () => text('😀😀😀😀', 'p', 3)],
    ['wrong-type p must be 1 to 64 letters, digits, - or _', { value: 'a b' }, () => id('a b', 'p')],
    ['wrong-type p must be 1 to 64 letters, digits, - or _', { value: 5 }, () => id(5, 'p')],
    ['wrong-type p must be 1 to 64 letters, digits, - or _', { value: LONG_ID }, () => id(LONG_ID, 'p')],
    ['wrong-type p must be true or false', { value: 'true' }, () => flag('true', 'p')],
    ['not-an-integer p must be a whole number', { value: 1.5 }, () => whole(1.5, 'p', 0, 3)],
    ['out-of-range p must be 0 to 3', { value: -1, min: 0, max: 3 }, () => whole(-1, 'p', 0, 3)],
    ['out-of-range p must be 0 to 3', { value: 3.1, min: 0, max: 3 }, () => measured(3.1, 'p', 0, 3)],
    ['wrong-type p must be a number, or null', { value: '1' }, () => measured('1', 'p', 0, 3)],
    ['unknown-word p must be one of a, b', { value: 'c' }, () => word('c', 'p', ['a', 'b'])],
    ['duplicate p[1].id stands twice', { value: 'a' }, () => entries(TWICE, 'p', (each) => each as { id: string })],
    ['wrong-count times must have 2 entries, not 1', ONE_OF_TWO, () => requireShape(program({ times: [0] }))],
    [
      'wrong-count positions[0] must have 2 entries, not 1',
      ONE_OF_TWO,
      () => requireShape(program({ positions: [[0]] })),
    ],
  ])('%s: %o', (refusal, details, work) => {
    expect(refusalOf(work)).toEqual([refusal, details]);
  });

  it('accepts a value at a limit', () => {
    expect([text('😀😀😀', 'p', 3), text('a', 'p', 3, 1), list([1], 'p', 1)]).toEqual(['😀😀😀', 'a', [1]]);
    expect([whole(0, 'p', 0, 3), whole(3, 'p', 0, 3), measured(null, 'p', 0, 3)]).toEqual([0, 3, null]);
    expect(Object.is(measured(-0, 'p', 0, 3), 0), '-0 is read as 0').toBe(true);
    expect(wholes([-0, 3], 'p', 2, 3).map((each) => Object.is(each, -0))).toEqual([false, false]);
    expect([id('a'.repeat(64), 'p'), id('-_Z9', 'p')]).toEqual(['a'.repeat(64), '-_Z9']);
  });
});

describe('a refusal inside a list or an object', () => {
  it('names both places', () => {
    const inner = () => whole(5, 'firmware', 0, 3);
    expect(refusalOf(() => within('p', () => void inner()))).toEqual([
      'out-of-range p.firmware must be 0 to 3',
      { value: 5, min: 0, max: 3 },
    ]);
  });

  it('lets any other error pass as it is', () => {
    const fault = new RangeError('something else');
    expect(() =>
      within('p', () => {
        throw fault;
      }),
    ).toThrow(fault);
  });
});
