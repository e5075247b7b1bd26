import * as v from 'valibot';
import { describe, expect, it } from 'vitest';
import { stepText } from '../../../src/app/messages/index.js';
import {
  backupSchema,
  draftSchema,
  modelSchema,
  settingSchema,
  unfinishedSchema,
} from '../../../src/app/storage/records.js';
import { MODEL, SETTING, VERSION } from '../../program/library-examples.js';
import { programOf } from '../programs.js';

const PROGRAM = programOf('Q', [1000, 0, 100, 18000]);
const DRAFT = {
  key: 'timer/Q/536/3/3/0',
  baseline: PROGRAM,
  working: PROGRAM,
  texts: {},
  history: { past: [], future: [], open: null },
  savedAt: 5,
  simulated: false,
};
const WRITE = {
  kind: 'write',
  key: 'a',
  startedAt: 5,
  before: PROGRAM,
  goal: PROGRAM,
  readAt: 4,
  seenAt: null,
};
const BACKUP = { key: 'a', savedAt: 5, reason: 'write', program: PROGRAM, simulated: false };

/** Each place of a program that can be spoilt, and with what. */
const SPOILT: [string, object][] = [
  ...[1e300, -1, 65536, 1.5, Number.NaN, Number.POSITIVE_INFINITY, null, '100'].map((value): [string, object] => [
    `a time of ${value}`,
    { times: [1000, 0, value, 18000] },
  ]),
  ...[256, -1, 0.5, Number.NaN].map((value): [string, object] => [
    `a position of ${value}`,
    { positions: PROGRAM.positions.map((row, i) => (i === 1 ? [value, ...row.slice(1)] : row)) },
  ]),
  ['an idle throttle of 256', { idleThrottle: 256 }],
  ['a memory past the last', { memory: 4 }],
  ['a memory that is none', { memory: -1 }],
  ['a time too few', { times: [1000, 0, 100] }],
  ['a servo too many', { positions: [...PROGRAM.positions, PROGRAM.positions[0]] }],
  ['a class of two letters', { identity: { ...PROGRAM.identity, timerClass: 'QQ' } }],
  ['five digits of firmware', { identity: { ...PROGRAM.identity, firmware: '53600' } }],
  [
    'more positions than a frame can hold',
    {
      identity: { ...PROGRAM.identity, functions: 100 },
      times: Array(101).fill(0),
      positions: Array(3).fill(Array(101).fill(0)),
    },
  ],
];
const spoil = (change: object) => ({ ...PROGRAM, ...change });

it('records that are right are read', () => {
  for (const [schema, record] of [
    [draftSchema, DRAFT],
    [unfinishedSchema, WRITE],
    [backupSchema, BACKUP],
  ] as const) {
    expect(v.safeParse(schema as v.GenericSchema, record).output).toEqual(record);
  }
});

it.each(SPOILT)('%s is refused wherever it comes from a timer or goes to one', (_, change) => {
  const bad = spoil(change);
  expect([
    v.is(draftSchema, { ...DRAFT, baseline: bad }),
    v.is(unfinishedSchema, { ...WRITE, before: bad }),
    v.is(unfinishedSchema, { ...WRITE, goal: bad }),
    v.is(backupSchema, { ...BACKUP, program: bad }),
  ]).toEqual([false, false, false, false]);
});

describe('what a pilot has typed', () => {
  it('can be read back, also when no timer could hold it', () => {
    const working = {
      ...PROGRAM,
      times: [1000, 0, 99_990_000, 18000],
      positions: PROGRAM.positions.map((row) => row.map(() => -999_999)),
    };
    expect(v.is(draftSchema, { ...DRAFT, working })).toBe(true);
  });

  it.each([
    { memory: 4 },
    { times: [1000, 0, 100] },
    { positions: [] },
    { identity: { ...PROGRAM.identity, memories: 0 } },
  ])('has the shape of a timer: not %j', (change) => {
    expect(v.is(draftSchema, { ...DRAFT, working: spoil(change) })).toBe(false);
  });

  it.each([1e300, 1.5, Number.NaN])('cannot be a time of %s', (time) => {
    expect(v.is(draftSchema, { ...DRAFT, working: { ...PROGRAM, times: [1000, 0, time, 18000] } })).toBe(false);
  });

  it('is lost only when its history is impossible', () => {
    const state = { working: spoil({ times: [1e300] }), texts: {} };
    const past = [{ name: { code: 'change', params: {} }, state }];
    expect(v.parse(draftSchema, { ...DRAFT, history: { past, future: [], open: null } })).toEqual({
      ...DRAFT,
      history: undefined,
    });
  });

  it.each<[former: string, params: object, name: object]>([
    ['type', { field: 'time:1' }, { code: 'change', params: { field: 'time:1' } }],
    ['revert-row', { slot: 2 }, { code: 'change', params: { slot: 2 } }],
    ['copy-servo', { from: 0, to: 2 }, { code: 'change', params: { from: 0, to: 2 } }],
    ['reverse-servo', { servo: 1 }, { code: 'change', params: { servo: 1 } }],
    ['revert-column', { name: 'S1' }, { code: 'change', params: { name: 'S1' } }],
    ['finish-write', {}, { code: 'open', params: {} }],
    ['restore', {}, { code: 'open', params: {} }],
    ['lay-over', {}, { code: 'open', params: {} }],
    ['load-setting', { name: 'calm' }, { code: 'open', params: { name: 'calm' } }],
    ['saved-elsewhere', {}, { code: 'open', params: {} }],
    ['shift', { slot: 3, by: 50 }, { code: 'shift', params: { slot: 3, by: 50 } }],
  ])('keeps the history of before, in which a step is called “%s”', (code, params, name) => {
    const state = { working: PROGRAM, texts: {} };
    const read = (step: object) =>
      v.parse(draftSchema, { ...DRAFT, history: { past: [{ name: step, state }], future: [], open: null } }).history;
    expect(read({ code, params })).toEqual(read(name));
    expect(read({ code, params })?.past).toMatchObject([{ name }]);
    expect(read({ code: 'never-used', params })).toBeUndefined();
  });

  it('says of a servo that was copied to another which of them has changed', () => {
    expect(stepText(PROGRAM.identity, { code: 'change', params: { from: 0, to: 2 } })).toBe('change of S3');
  });
});

it.each<[string, object]>([
  ['of two layouts', { working: programOf('Q', [0, 1, 2]) }],
  ['without the time of saving', { savedAt: Number.NaN }],
  ['saved later than any date', { savedAt: 1e300 }],
  ['with a number in place of a text', { texts: { 'time/1': 5 } }],
  ['with a text that is far too long', { texts: { 'time/1': 'x'.repeat(10_001) } }],
  ['with more texts than fields', { texts: Object.fromEntries(Array.from({ length: 1001 }, (_, i) => [i, 'x'])) }],
])('a draft %s is refused', (_, change) => {
  expect(v.is(draftSchema, { ...DRAFT, ...change })).toBe(false);
});

it('a write between two layouts is refused', () => {
  expect(v.is(unfinishedSchema, { ...WRITE, goal: programOf('Q', [0, 1, 2]) })).toBe(false);
});

describe('a model', () => {
  const stored = (servos: unknown) => ({ key: 'm', model: { ...MODEL, servos }, changedAt: 5, verified: [] });
  const [use] = MODEL.servos;

  it('that was kept with the ends of a servo in the wrong order is read with them in order', () => {
    const { output } = v.safeParse(modelSchema, stored([use, { ...use, low: 95, high: 20 }]));
    expect(output).toEqual(stored([use, { ...use, low: 20, high: 95 }]));
  });

  it.each([null, {}, [null], [{ ...use, low: '95', high: 20 }], [{ ...use, low: 131, high: 20 }]])(
    'with servos %o is none',
    (servos) => expect(v.is(modelSchema, stored(servos))).toBe(false),
  );
});

describe('the record of a setting', () => {
  const stored = { key: SETTING.id, changedAt: 1, setting: SETTING };

  it('of an earlier version of the page has no versions, and is read as it is', () => {
    expect(v.parse(settingSchema, stored)).toEqual(stored);
    expect(v.parse(settingSchema, { ...stored, versions: [VERSION] })).toEqual({ ...stored, versions: [VERSION] });
  });

  it.each([[5], [[{ ...VERSION, until: 'today' }]], [Array.from({ length: 21 }, () => VERSION)]])(
    'whose versions cannot be read is not lost (%#)',
    (versions) => expect(v.parse(settingSchema, { ...stored, versions })).toEqual(stored),
  );
});
