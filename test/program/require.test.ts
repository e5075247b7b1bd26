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

describe('a value from outside is refused with its place, what it must be, and its limits', () => {
  it.each<[string, () => unknown, unknown[]]>([
    ['no object', () => record(5, 'p'), ['wrong-type', 'p', 'p must be an object', { value: 5 }]],
    ['null', () => record(null, 'p'), ['wrong-type', 'p', 'p must be an object', { value: null }]],
    ['a list in its place', () => record([], 'p'), ['wrong-type', 'p', 'p must be an object', { value: [] }]],
    ['no list', () => list({}, 'p', 1), ['wrong-type', 'p', 'p must be a list', { value: {} }]],
    [
      'a long list',
      () => list([1, 2], 'p', 1),
      ['wrong-count', 'p', 'p must have at most 1 entries', { value: 2, max: 1 }],
    ],
    ['no text', () => text(5, 'p', 3), ['wrong-type', 'p', 'p must be a text', { value: 5 }]],
    [
      'a long text',
      () => text('abcd', 'p', 3, 1),
      ['out-of-range', 'p', 'p must have 1 to 3 characters', { value: 4, min: 1, max: 3 }],
    ],
    [
      'a short text',
      () => text('', 'p', 3, 1),
      ['out-of-range', 'p', 'p must have 1 to 3 characters', { value: 0, min: 1, max: 3 }],
    ],
    [
      'a text that is too long to be gone through',
      () => text('😀😀😀😀', 'p', 3),
      ['out-of-range', 'p', 'p must have 0 to 3 characters', { value: 8, min: 0, max: 3 }],
    ],
    ['an id', () => id('a b', 'p'), ['wrong-type', 'p', 'p must be 1 to 64 letters, digits, - or _', { value: 'a b' }]],
    [
      'a number as an id',
      () => id(5, 'p'),
      ['wrong-type', 'p', 'p must be 1 to 64 letters, digits, - or _', { value: 5 }],
    ],
    [
      'a long id',
      () => id('a'.repeat(65), 'p'),
      ['wrong-type', 'p', 'p must be 1 to 64 letters, digits, - or _', { value: 'a'.repeat(65) }],
    ],
    ['a flag', () => flag('true', 'p'), ['wrong-type', 'p', 'p must be true or false', { value: 'true' }]],
    [
      'part of a number',
      () => whole(1.5, 'p', 0, 3),
      ['not-an-integer', 'p', 'p must be a whole number', { value: 1.5 }],
    ],
    [
      'a number too small',
      () => whole(-1, 'p', 0, 3),
      ['out-of-range', 'p', 'p must be 0 to 3', { value: -1, min: 0, max: 3 }],
    ],
    [
      'a number too large',
      () => measured(3.1, 'p', 0, 3),
      ['out-of-range', 'p', 'p must be 0 to 3', { value: 3.1, min: 0, max: 3 }],
    ],
    ['no number', () => measured('1', 'p', 0, 3), ['wrong-type', 'p', 'p must be a number, or null', { value: '1' }]],
    ['another word', () => word('c', 'p', ['a', 'b']), ['unknown-word', 'p', 'p must be one of a, b', { value: 'c' }]],
    [
      'an id twice',
      () => entries([{ id: 'a' }, { id: 'a' }], 'p', (each) => each as { id: string }),
      ['duplicate', 'p[1].id', 'p[1].id stands twice', { value: 'a' }],
    ],
    [
      'too few times',
      () => requireShape(program({ times: [0] })),
      ['wrong-count', 'times', 'times must have 2 entries, not 1', { value: 1, min: 2, max: 2 }],
    ],
    [
      'too few positions of a servo',
      () => requireShape(program({ positions: [[0]] })),
      ['wrong-count', 'positions[0]', 'positions[0] must have 2 entries, not 1', { value: 1, min: 2, max: 2 }],
    ],
  ])('%s', (_, work, refusal) => {
    expect(refusalOf(work)).toEqual(refusal);
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
      'out-of-range',
      'p.firmware',
      'p.firmware must be 0 to 3',
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
