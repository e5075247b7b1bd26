import { describe, expect, it } from 'vitest';
import { choicesOf, conclude, joined, type Said, type Seen, type Tried } from '../../../src/app/settle/conclusions.js';
import { cellOf } from '../../../src/app/settle/try-position.js';
import type { Answers } from '../../../src/app/storage/records.js';
import type { TimerProgram } from '../../../src/program/index.js';

const identity = { timerClass: 'B', firmware: '536', functions: 10, memories: 4, servos: 3 };
const USUAL = { order: 'low-first', unit: 'hundredths' } as const;
const SWAPPED = { order: 'high-first', unit: 'hundredths' } as const;
const TENTHS = { order: 'low-first', unit: 'tenths' } as const;

const nothing: Seen = {
  identity,
  times: [7, 50, 100, 18_000],
  indices: [],
  delays: [],
  away: null,
  there: null,
  zeros: null,
  unlock: null,
};

/** A position of S1 at function 1, tried while the servos stand at DT. */
const AWAY: Tried = { servo: 0, slot: 1, order: 'function-first', at: 10, end: 'kept' };
const THERE: Tried = { ...AWAY, at: 1 };

function concluded(seen: Partial<Seen>, said: Said = {}): Answers {
  const { reserved: _, ...answers } = conclude({ ...nothing, ...seen }, said);
  return answers;
}

describe('times', () => {
  const rows: [string, Partial<Seen>, Said, Answers][] = [
    ['one way', {}, { times: [SWAPPED] }, { order: 'high-first', unit: 'hundredths' }],
    ['ways that agree about the unit alone', {}, { times: [USUAL, SWAPPED] }, { unit: 'hundredths' }],
    ['ways that agree about the order alone', {}, { times: [USUAL, TENTHS] }, { order: 'low-first' }],
    ['all ways', {}, { times: [USUAL, { ...SWAPPED, unit: 'tenths' }] }, {}],
    ['from launch, but they are not known', {}, { count: 'launch' }, {}],
    ['from launch, and they rise', {}, { count: 'launch', times: [USUAL] }, { ...USUAL, count: 'launch' }],
    ['from launch, and they fall', { times: [7, 100, 50] }, { count: 'launch', times: [USUAL] }, USUAL],
    [
      'from launch, and they fall in one of the ways',
      { times: [7, 0x0101, 0x0200] },
      { count: 'launch', times: [USUAL, SWAPPED] },
      { unit: 'hundredths' },
    ],
    ['from the function before', {}, { count: 'previous' }, { count: 'previous' }],
    ['from the function before, on Q', { identity: { ...identity, timerClass: 'Q' } }, { count: 'previous' }, {}],
  ];
  it.each(rows)('%s', (_, seen, said, answers) => {
    expect(concluded(seen, said)).toEqual(answers);
  });

  it('that look the same are one choice', () => {
    expect(choicesOf([50, 18_000]).map(({ ways, shown }) => [ways, shown])).toEqual([
      [[USUAL], [50, 18_000]],
      [[SWAPPED], [12_800, 20_550]],
      [[TENTHS], [500, 180_000]],
      [[{ ...TENTHS, order: 'high-first' }], [128_000, 205_500]],
    ]);
    expect(choicesOf([0x0101]).map(({ ways }) => ways.length)).toEqual([2, 2]);
    expect(choicesOf([0]).map(({ ways }) => ways.length)).toEqual([4]);
  });
});

describe('memories', () => {
  const rows: [string, (number | null)[], number | undefined, Answers['memories']][] = [
    ['0, and nobody knows', [0, 0], undefined, 'from-0'],
    ['0, and M1', [0, 0], 1, 'from-0'],
    ['0, and another', [0, 0], 2, undefined],
    ['0, and a handheld that counts from 0', [0, 0], 0, undefined],
    ['as many as there are, and nobody knows', [4, 4], undefined, 'from-1'],
    ['as many as there are, and the last', [4, 4], 4, 'from-1'],
    ['as many as there are, and another', [4, 4], 2, undefined],
    ['one between, and nobody knows', [2, 2], undefined, undefined],
    ['one between, and the one of that number', [2, 2], 2, 'from-1'],
    ['one between, and the next', [2, 2], 3, 'from-0'],
    ['one between, and another', [2, 2], 4, undefined],
    ['more than there are', [5, 5], 5, undefined],
    ['none', [null, null], 1, 'unnumbered'],
    ['none in one of two', [null, 0], 1, undefined],
    ['two', [0, 1], 1, undefined],
    ['one once', [0], 1, undefined],
    ['none at all', [], 1, undefined],
  ];
  it.each(rows)('%s', (_, indices, memory, memories) => {
    const said = memory === undefined ? {} : { memory };
    expect(concluded({ indices }, said).memories).toBe(memories);
  });
});

describe('a position', () => {
  const end = (tried: Tried, ended: Tried['end']): Tried => ({ ...tried, end: ended });
  const servoFirst = (tried: Tried): Tried => ({ ...tried, order: 'servo-first' });
  const yes = { away: true, there: true };
  const only = { away: false, there: true };
  const never = { away: false, there: false };
  const usual = { layout: 'function-first' } as const;
  const anywhere = { ...usual, stores: 'anywhere' } as const;
  const both = { away: AWAY, there: THERE };
  const lost = end(AWAY, 'unchanged');
  const lostThere = end(THERE, 'unchanged');
  const exchanged = end(AWAY, 'exchanged');
  const rows: [string, Partial<Seen>, Said, Answers][] = [
    ['kept away from the servos', { away: AWAY }, {}, anywhere],
    ['kept at an unknown place', { away: { ...AWAY, at: null } }, {}, usual],
    ['kept where they stand alone', { there: THERE }, only, usual],
    ['exchanged', { away: exchanged }, {}, { layout: 'servo-first', stores: 'anywhere' }],
    ['exchanged where the servos stand', { away: { ...exchanged, at: 0 } }, {}, { layout: 'servo-first' }],
    ['exchanged, in the other order', { away: servoFirst(exchanged) }, {}, anywhere],
    ['kept in both orders', { away: AWAY, there: servoFirst(THERE) }, yes, { stores: 'anywhere', moves: 'always' }],
    ['unchanged away, kept where they stand', { away: lost, there: THERE }, only, { ...usual, stores: 'there' }],
    ['unchanged away in the wrong order', { away: servoFirst(lost), there: THERE }, only, usual],
    ['unchanged at both', { away: lost, there: lostThere }, never, {}],
    ['kept away, unchanged where they stand', { away: AWAY, there: lostThere }, only, usual],
    ['unclear', { away: end(AWAY, 'unclear'), there: end(THERE, 'unclear') }, yes, {}],
    ['that moves always', both, yes, { ...anywhere, moves: 'always' }],
    ['that moves where they stand', both, only, { ...anywhere, moves: 'there' }],
    ['that moves never', both, never, { ...anywhere, moves: 'never' }],
    ['that moves only elsewhere', both, { away: true, there: false }, anywhere],
    ['of whose movement one half is known', both, { there: true }, anywhere],
  ];
  it.each(rows)('%s', (_, seen, said, answers) => {
    expect(concluded(seen, said)).toEqual(answers);
  });
});

it('an answer takes what half of them take, once there are five', () => {
  expect(concluded({ delays: [50, 51, 400, 52] }).delay).toBeUndefined();
  expect(concluded({ delays: [50, 51.4, 400, 52, 50] }).delay).toBe(51);
});

it('the reserved time is noted on B and E', () => {
  expect(conclude(nothing, {}).reserved).toBe(7);
  expect(conclude({ ...nothing, identity: { ...identity, timerClass: 'Q' } }, {}).reserved).toBeUndefined();
});

it('what two walks contradict each other in is not settled; of a measure the later one counts', () => {
  const before: Answers = { layout: 'servo-first', zeros: 'answered', delay: 50, reserved: 0 };
  const now: Answers = { layout: 'function-first', unlock: '6A', delay: 70, reserved: 3 };
  expect(joined(before, now)).toEqual({ zeros: 'answered', unlock: '6A', delay: 70, reserved: 3 });
});

describe('the position to try', () => {
  const program: TimerProgram = {
    identity,
    memory: 0,
    times: Array.from({ length: 11 }, (_, slot) => 50 * slot),
    positions: Array.from({ length: 3 }, () => Array.from({ length: 11 }, () => 60)),
    idleThrottle: null,
  };
  const withAt = (...cells: [servo: number, slot: number, at: number][]): TimerProgram => ({
    ...program,
    positions: program.positions.map((row, servo) =>
      row.map((at, slot) => cells.find(([s, f]) => s === servo && f === slot)?.[2] ?? at),
    ),
  });
  const field = (servo: number, slot: number) => ({ kind: 'position', servo, slot });

  it('goes towards the middle', () => {
    expect(cellOf(program)).toEqual({ field: field(0, 1), value: 75 });
    expect(cellOf(withAt([0, 1, 100]))).toEqual({ field: field(0, 1), value: 85 });
  });

  it('has a value that the exchanged one does not have', () => {
    expect(cellOf(withAt([1, 0, 75]))).toEqual({ field: field(0, 1), value: 76 });
  });

  it('is none that could not be put back', () => {
    expect(cellOf(withAt([0, 1, 131]))).toEqual({ field: field(2, 1), value: 75 });
    expect(cellOf(withAt([1, 0, 131]))).toEqual({ field: field(2, 1), value: 75 });
    expect(cellOf({ ...program, positions: program.positions.map((row) => row.map(() => 200)) })).toBeNull();
  });
});
