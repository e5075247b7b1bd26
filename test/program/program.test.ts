import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  changeRequests,
  checkProgram,
  differences,
  fieldKey,
  fieldsOf,
  hasErrors,
  type ProgramField,
  sameKind,
  seconds,
  slotKind,
  type TimerProgram,
  valueAt,
  withValue,
} from '../../src/program/index.js';
import { CodecError, encodeRequest } from '../../src/protocol/index.js';
import { edited } from '../client/bench.js';
import { B536, CAPTURED_POSITIONS, SMALL } from '../protocol/vectors.js';

const Q536 = { ...B536, timerClass: 'Q' };

/** A program in which nothing is unusual. */
function usual(timerClass: string): TimerProgram {
  const isQ = timerClass === 'Q';
  return {
    identity: { ...B536, timerClass },
    memory: 0,
    times: [isQ ? 1000 : 0, 50, 150, 250, 350, 450, 550, 650, 750, 850, 18000],
    positions: [CAPTURED_POSITIONS, CAPTURED_POSITIONS, CAPTURED_POSITIONS],
    idleThrottle: isQ ? 30 : null,
  };
}

function found(program: TimerProgram, baseline?: TimerProgram): string[] {
  return checkProgram(program, { baseline }).map(
    ({ severity, code, field }) => `${severity} ${code} ${field ? fieldKey(field) : '-'}`,
  );
}

describe('seconds', () => {
  it('are hundredths of a second, whatever the fractions of two do', () => {
    for (let hundredths = 0; hundredths <= 65535; hundredths++) {
      if (seconds(hundredths / 100) !== hundredths) expect.fail(`${hundredths / 100} s`);
    }
  });

  it.each([
    [655.36, 'out-of-range'],
    [-0.01, 'out-of-range'],
    [0.005, 'not-an-integer'],
    [Number.NaN, 'not-an-integer'],
    [Number.POSITIVE_INFINITY, 'not-an-integer'],
    ['180', 'not-an-integer'],
  ])('of %s are refused', (value, code) => {
    expect(() => seconds(value as number)).toThrow(expect.objectContaining({ code, field: 'seconds' }));
  });
});

describe('the fields of a program', () => {
  it('are the times, the positions servo by servo, the idle throttle', () => {
    expect(fieldsOf(SMALL).map(fieldKey)).toEqual(['time:0', 'time:1', 'position:0:0', 'position:0:1', 'idleThrottle']);
    expect(fieldsOf(B536)).toHaveLength(11 + 33 + 1);
  });

  it('can each be read and replaced, and nothing else changes', () => {
    const program = usual('Q');
    for (const field of fieldsOf(program.identity)) {
      const changed = withValue(program, field, 77);
      expect(valueAt(changed, field)).toBe(77);
      expect(differences(program, changed)).toEqual([{ field, from: valueAt(program, field), to: 77 }]);
    }
    expect(program).toEqual(usual('Q'));
  });

  it.each<[string, unknown, string]>([
    ['a slot after DT', { kind: 'time', slot: 11 }, 'slot'],
    ['a slot before start', { kind: 'time', slot: -1 }, 'slot'],
    ['a servo that it does not have', { kind: 'position', servo: 3, slot: 0 }, 'servo'],
    ['a slot of a servo', { kind: 'position', servo: 2, slot: 11 }, 'slot'],
    ['a kind that nobody knows', { kind: 'idle', slot: 0 }, 'kind'],
  ])('are refused for %s, because a change of nothing would be called verified', (_, field, name) => {
    const act = (): unknown => withValue(usual('Q'), field as ProgramField, 77);
    expect(act).toThrow(expect.objectContaining({ name: 'CodecError', code: 'out-of-range', field: name }));
  });

  it('are called start, function and DT by the number of functions', () => {
    expect([0, 1, 9, 10].map((slot) => slotKind(B536, slot))).toEqual(['start', 'function', 'function', 'dt']);
    expect([0, 1].map((slot) => slotKind(SMALL, slot))).toEqual(['start', 'dt']);
  });

  it('belong to timers of one kind only when class, firmware and numbers agree', () => {
    expect(sameKind(B536, { ...B536 })).toBe(true);
    for (const other of [{ timerClass: 'Q' }, { firmware: '537' }, { functions: 9 }, { memories: 5 }, { servos: 2 }]) {
      expect(sameKind(B536, { ...B536, ...other })).toBe(false);
    }
  });
});

describe('the requests that turn one program into another', () => {
  it('are none when nothing differs, whichever memory the programs come from', () => {
    expect(changeRequests(usual('B'), { ...usual('B'), memory: 3 })).toEqual([]);
  });

  it('are one SETTIMERS, a SETSERVO for each position, a SETLOWRPM', () => {
    const from = usual('Q');
    const to = { ...edited(from, [0, 900], [10, 6000], [2, 10, 1]), idleThrottle: 5 };
    expect(changeRequests(from, to)).toEqual([
      { name: 'SETTIMERS', times: to.times },
      { name: 'SETSERVO', function: 10, servo: 2, position: 1 },
      { name: 'SETLOWRPM', idleThrottle: 5 },
    ]);
  });

  it('do not touch an unknown idle throttle', () => {
    expect(changeRequests(usual('Q'), { ...usual('Q'), idleThrottle: null })).toEqual([]);
  });

  it('are refused for programs of different layouts', () => {
    const other: TimerProgram = { ...usual('B'), identity: SMALL, times: [0, 0], positions: [[0, 0]] };
    expect(() => changeRequests(usual('B'), other)).toThrowError(CodecError);
    expect(() => differences(usual('B'), other)).toThrowError(
      expect.objectContaining({ code: 'wrong-count', field: 'identity' }),
    );
    expect(() => differences({ ...usual('B'), times: [1] }, usual('B'))).toThrowError(
      expect.objectContaining({ code: 'wrong-count', field: 'times' }),
    );
  });
});

describe('the check', () => {
  it('finds nothing in a usual program', () => {
    expect(found(usual('B'))).toEqual([]);
    expect(found(usual('Q'))).toEqual([]);
    expect(found(usual('E'))).toEqual([]);
  });

  const cases: [string, string, Record<number, number>, string[]][] = [
    ['a time past 16 bits', 'B', { 10: 65536 }, ['error time-out-of-range time:10']],
    ['a negative time', 'B', { 3: -1 }, ['error time-out-of-range time:3']],
    ['part of a hundredth', 'B', { 3: 250.5 }, ['error time-not-whole time:3']],
    ['no number at all', 'B', { 3: Number.NaN }, ['error time-not-whole time:3']],
    ['a falling time on Q', 'Q', { 5: 340 }, ['serious time-falls time:5']],
    ['a falling time on B', 'B', { 5: 340 }, ['warning time-falls time:5']],
    ['a falling time on E', 'E', { 5: 340 }, ['warning time-falls time:5']],
    [
      'a falling time on a class that nobody knows',
      'X',
      { 5: 340 },
      ['serious time-falls time:5', 'warning class-unknown -'],
    ],
    ['a DT before the last function', 'B', { 10: 800 }, ['warning time-falls time:10', 'serious dt-short time:10']],
    ['nothing of the order beside a time that is no time', 'B', { 4: 65536 }, ['error time-out-of-range time:4']],
    ['a motor stop at DT', 'Q', { 0: 18000 }, ['warning motor-run-long time:0', 'warning time-outside-manual time:0']],
    ['a motor stop where DT is no time', 'Q', { 10: -1 }, ['error time-out-of-range time:10']],
    ['the shortest and the longest time of the manual on Q', 'Q', { 1: 10, 9: 9990 }, []],
    ['a time shorter than in the manual on Q', 'Q', { 1: 9 }, ['warning time-outside-manual time:1']],
    ['the shortest time of the manual on B', 'B', { 1: 1 }, []],
    ['a time of nothing on B', 'B', { 1: 0 }, ['warning time-outside-manual time:1']],
    ['two functions at one time', 'B', { 5: 350 }, ['warning position-never-reached time:5']],
    [
      'a motor stop after DT',
      'Q',
      { 10: 6000, 0: 6100 },
      ['serious motor-stop-after-dt time:0', 'warning motor-run-long time:0'],
    ],
    ['a motor run of 40 s', 'Q', { 0: 4000 }, []],
    ['a motor run of more than 40 s', 'Q', { 0: 4010 }, ['warning motor-run-long time:0']],
    ['a reserved time on B', 'B', { 0: 12345 }, []],
    ['a step finer than a tenth on Q', 'Q', { 1: 55 }, ['warning time-too-fine time:1']],
    ['hundredths for function 2 on B', 'B', { 2: 151 }, []],
    ['hundredths for function 3 on B', 'B', { 3: 251 }, ['warning time-too-fine time:3']],
    ['a DT of part of a second', 'B', { 10: 18050 }, ['warning time-too-fine time:10']],
    ['a function past 99.9 s', 'B', { 9: 10000 }, ['warning time-outside-manual time:9']],
    [
      'a function 2 past 9.99 s on B',
      'B',
      { 2: 1000, 3: 1010, 4: 1020, 5: 1030, 6: 1040, 7: 1050, 8: 1060, 9: 1070 },
      ['warning time-outside-manual time:2'],
    ],
    ['a DT under a minute', 'B', { 10: 5900 }, ['warning dt-short time:10']],
    ['a DT of a minute', 'B', { 10: 6000 }, []],
    ['a DT of ten seconds', 'B', { 10: 1000 }, ['warning dt-short time:10']],
    [
      'a DT in hundredths that was meant in seconds',
      'B',
      { 9: 100, 8: 90, 7: 80, 6: 70, 5: 60, 4: 50, 3: 40, 2: 30, 1: 20, 10: 180 },
      ['warning time-too-fine time:10', 'serious dt-short time:10'],
    ],
    ['no rule of steps on E', 'E', { 3: 251 }, []],
  ];
  const bySlot = (times: Record<number, number>) =>
    Object.entries(times).map(([slot, time]) => [Number(slot), time] as const);
  for (const [name, timerClass, times, expected] of cases) {
    it(name, () => expect(found(edited(usual(timerClass), ...bySlot(times)))).toEqual(expected));
  }

  it('says when equal times have the same positions, so that no position is lost', () => {
    const program = edited(usual('B'), [5, 350], [0, 5, 55], [1, 5, 55], [2, 5, 55]);
    expect(found(program)).toEqual(['warning time-repeats time:5']);
  });

  it('says that positions are never reached when equal times differ in only one servo', () => {
    const program = edited(usual('B'), [5, 350], [0, 5, 55], [1, 5, 55]);
    expect(found(program)).toEqual(['warning position-never-reached time:5']);
  });

  it('refuses a position past the last step, but keeps one that was read', () => {
    const read = edited(usual('B'), [1, 4, 200]);
    expect(found(read)).toEqual(['error position-out-of-range position:1:4']);
    expect(found(read, read)).toEqual(['warning position-as-read position:1:4']);
    expect(found(edited(read, [1, 4, 201]), read)).toEqual(['error position-out-of-range position:1:4']);
    // No timer holds such a time.
    const late = edited(usual('B'), [10, 65536]);
    expect(found(late, late)).toEqual(['error time-out-of-range time:10']);
  });

  it('checks the order of the times beside a position that is out of range', () => {
    expect(found(edited(usual('B'), [5, 340], [1, 5, 131]))).toEqual([
      'error position-out-of-range position:1:5',
      'warning time-falls time:5',
    ]);
  });

  it.each<[TimerProgram, object]>([
    [edited(usual('B'), [1, 4, 200]), { min: 0, max: 130 }],
    [edited(usual('B'), [10, 65536]), { min: 0, max: 65535 }],
    [
      { ...usual('Q'), idleThrottle: 256 },
      { min: 0, max: 255 },
    ],
    [edited(usual('B'), [5, 340]), { previous: 350 }],
    [edited(usual('B'), [5, 350]), { previous: 350 }],
    [edited(usual('Q'), [0, 18100], [10, 18000]), { dt: 18000 }],
    [edited(usual('Q'), [0, 4010]), { limit: 4000 }],
    [edited(usual('B'), [9, 10000]), { min: 10, max: 9990 }],
    [edited(usual('B'), [3, 251]), { step: 10 }],
    [edited(usual('B'), [10, 5900]), { limit: 6000 }],
    [{ ...usual('Q'), idleThrottle: 101 }, { limit: 100 }],
    [usual('X'), { timerClass: 'X' }],
  ])('gives the limits with each finding (%#)', (program, params) => {
    expect(checkProgram(program)[0]?.params).toEqual(params);
  });

  it('gives the value and the limit for a position that was read', () => {
    const read = edited(usual('B'), [1, 4, 200]);
    expect(checkProgram(read, { baseline: read })[0]?.params).toEqual({ value: 200, max: 130 });
  });

  it('warns of a DT at which no servo moves, however many move at other times', () => {
    const still = CAPTURED_POSITIONS.with(10, CAPTURED_POSITIONS[9] as number);
    const positioned = (...positions: (readonly number[])[]) => found({ ...usual('Q'), positions });
    expect(positioned(still, still, still)).toEqual(['warning dt-moves-nothing time:10']);
    expect(positioned(still, CAPTURED_POSITIONS, still)).toEqual([]);
  });

  it('checks the idle throttle', () => {
    expect(found({ ...usual('Q'), idleThrottle: 100 })).toEqual([]);
    expect(found({ ...usual('Q'), idleThrottle: 255 })).toEqual(['warning throttle-unusual idleThrottle']);
    expect(found({ ...usual('Q'), idleThrottle: 101 })).toEqual(['warning throttle-unusual idleThrottle']);
    expect(found({ ...usual('Q'), idleThrottle: 256 })).toEqual(['error throttle-out-of-range idleThrottle']);
    expect(found({ ...usual('Q'), idleThrottle: 1.5 })).toEqual(['error throttle-not-whole idleThrottle']);
  });

  it('warns of a class it does not know, and checks no rule of a class', () => {
    expect(found(edited(usual('X'), [3, 251]))).toEqual(['warning class-unknown -']);
  });

  it('takes another limit for a short DT', () => {
    expect(checkProgram(usual('B'), { shortDt: 20000 }).map(({ code }) => code)).toEqual(['dt-short']);
    const inClimb = edited(usual('B'), [10, 900]);
    const found = checkProgram(inClimb, { shortDt: 500 }).filter(({ severity }) => severity === 'serious');
    expect(found, 'whatever the pilot calls short').toMatchObject([{ code: 'dt-short' }]);
  });

  it('calls only that an error which cannot be encoded', () => {
    const value = fc.oneof(
      fc.integer({ min: -300, max: 70000 }),
      fc.constantFrom(0, 130, 131, 255, 65535, 0.5, Number.NaN),
    );
    const anyField = fc.constantFrom(...fieldsOf(Q536));
    fc.assert(
      fc.property(fc.array(fc.tuple(anyField, value), { maxLength: 6 }), (changes) => {
        const from = usual('Q');
        const to = changes.reduce((program, [field, v]) => withValue(program, field, v), from);
        const encodable = (): boolean => {
          try {
            for (const request of changeRequests(from, to)) encodeRequest(request, { identity: to.identity });
            return true;
          } catch {
            return false;
          }
        };
        expect(hasErrors(checkProgram(to, { baseline: from }))).toBe(!encodable());
      }),
      { numRuns: 1000 },
    );
  });
});
