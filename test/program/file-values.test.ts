import { describe, expect, it } from 'vitest';
import { dateFromFile, dateToFile, programFromFile, programToFile } from '../../src/program/file-values.js';
import type { TimerProgram } from '../../src/program/index.js';
import { refusalOf } from './refusal.js';

const PROGRAM: TimerProgram = {
  identity: { timerClass: 'Q', firmware: '536', functions: 2, memories: 4, servos: 1 },
  memory: 1,
  times: [1000, 30, 18000],
  positions: [[15, 25, 115]],
  idleThrottle: 12,
};

/** As it stands in a file, with other values in some places. */
function file(other: object = {}): Record<string, unknown> {
  return { ...programToFile(PROGRAM), ...other };
}
const { slots: ROWS } = programToFile(PROGRAM) as { slots: object[] };

const slots = (at: number, other: object): object => ({
  slots: ROWS.map((row, index) => (index === at ? { ...row, ...other } : row)),
});

describe('a program in a file', () => {
  it('comes back as it was, its first time under the name of its class', () => {
    for (const [timerClass, name] of [
      ['Q', 'motorStop'],
      ['B', 'reserved'],
      ['E', 'reserved'],
    ] as const) {
      const program = { ...PROGRAM, identity: { ...PROGRAM.identity, timerClass } };
      expect(programToFile(program)).toMatchObject({ [name]: '10.00', memory: 'M2' });
      expect(programFromFile(programToFile(program), 'program')).toEqual(program);
    }
  });

  it('may have an unknown memory, or none', () => {
    const { memory: _, ...without } = file();
    expect(programToFile({ ...PROGRAM, memory: null })).toMatchObject({ memory: null });
    expect([programFromFile(file({ memory: null }), 'p').memory, programFromFile(without, 'p').memory]).toEqual([
      null,
      null,
    ]);
    expect(programFromFile(file({ memory: 'M4' }), 'p').memory).toBe(3);
  });

  it('may hold the longest time of a timer', () => {
    expect(programFromFile(file(slots(2, { time: '655.35' })), 'p').times[2]).toBe(65_535);
    expect(programFromFile(file(slots(2, { time: '0.00' })), 'p').times[2]).toBe(0);
  });

  const time = 'must be seconds with two decimals, such as "0.30"';
  it.each<[string, object, object]>([
    [
      'out-of-range p.slots[2].time must be 0.00 to 655.35',
      { value: 655.36, min: 0, max: 655.35 },
      slots(2, { time: '655.36' }),
    ],
    [`wrong-type p.slots[2].time ${time}`, { value: 1.25 }, slots(2, { time: 1.25 })],
    [`wrong-type p.slots[2].time ${time}`, { value: ' 1.25' }, slots(2, { time: ' 1.25' })],
    [`wrong-type p.slots[2].time ${time}`, { value: '01.25' }, slots(2, { time: '01.25' })],
    [`wrong-type p.motorStop ${time}`, { value: '1.250' }, { motorStop: '1.250' }],
    ['wrong-type p.slots must be a list', { value: 5 }, { slots: 5 }],
    ['wrong-count p.slots must have 3 entries, not 2', { value: 2, min: 3, max: 3 }, { slots: ROWS.slice(0, 2) }],
    [
      'wrong-count p.slots[1].positions must have 1 entries, not 0',
      { value: 0, min: 1, max: 1 },
      slots(1, { positions: [] }),
    ],
    ['unknown-word p.slots[1].slot must be “1”', { value: '2' }, slots(1, { slot: '2' })],
    ['unknown-word p.slots[2].slot must be “DT”', { value: '2' }, slots(2, { slot: '2' })],
    ['unknown-word p.memory must be one of M1, M2, M3, M4', { value: 'M5' }, { memory: 'M5' }],
    [
      'out-of-range p.slots[1].positions[0] must be 0 to 255',
      { value: 256, min: 0, max: 255 },
      slots(1, { positions: [256] }),
    ],
  ])('is refused: %s: %o', (refusal, details, other) => {
    expect(refusalOf(() => programFromFile(file(other), 'p'))).toEqual([refusal, details]);
  });
});

describe('a date in a file', () => {
  const whole = 'a time such as "2026-11-22T14:03:00.000Z"';

  it.each([0, 1_795_000_000_000, 8.64e15])('%i comes back as it was', (milliseconds) => {
    expect(dateFromFile(dateToFile(milliseconds), 'at')).toBe(milliseconds);
  });

  it.each<[string, unknown]>([
    ['one of a day that no month has', '2026-02-30T14:03:00.000Z'],
    ['a day alone', '2026-11-22'],
    ['one of another zone', '2026-11-22T14:03:00.000+01:00'],
    ['no date', 'yesterday'],
    ['a number', 1_795_000_000_000],
    ['an object', Object.create(null)],
    ['nothing', undefined],
    ['a list of one', ['2026-11-22T14:03:00.000Z']],
  ])('is refused: %s', (_, value) => {
    expect(refusalOf(() => dateFromFile(value, 'at'))).toEqual([`wrong-type at must be ${whole}`, { value }]);
  });

  it('cannot be before 1970', () => {
    expect(refusalOf(() => dateFromFile('1969-12-31T23:59:59.999Z', 'at'))).toEqual([
      'out-of-range at must be 0 to 8640000000000000',
      { value: -1, min: 0, max: 8.64e15 },
    ]);
  });
});
