import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Edit, putBack, replaceAll, setValues, withValues } from '../../../src/app/editing/edit.js';
import {
  fillDown,
  setInterval,
  shiftFrom,
  stepInterval,
  stepRange,
  stepValue,
} from '../../../src/app/editing/edits.js';
import { intervalAt } from '../../../src/app/editing/grid.js';
import { pasted, previewPaste } from '../../../src/app/editing/paste.js';
import {
  fieldKey,
  fieldsOf,
  manualRange,
  type ProgramField,
  type TimerProgram,
  valueAt,
} from '../../../src/program/index.js';
import { anyProgram, programAndRange, programOf, Q4, valuesOf } from './grid-programs.js';

const program = programOf();
const B4 = { ...Q4, timerClass: 'B' };

/** The times after an edit. */
function timesAfter(edit: Edit, before: TimerProgram = program): readonly number[] {
  return withValues(before, valuesOf(edit)).times;
}

function refusalIn(edit: Edit): string {
  return 'refused' in edit ? `${edit.refused.code} ${fieldKey(edit.refused.field)}` : 'done';
}

const byOrRefused = (edit: Edit, before: TimerProgram) => ('refused' in edit ? null : withValues(before, edit.values));

describe('an interval', () => {
  it('moves this function and those after it, and neither DT nor motor stop', () => {
    expect(timesAfter(setInterval(program, 2, 1000))).toEqual([1000, 50, 1050, 1300, 1550, 18000]);
  });

  it('of function 1 counts from launch, that of DT moves DT alone', () => {
    expect(timesAfter(setInterval(program, 1, 100))).toEqual([1000, 100, 1050, 1300, 1550, 18000]);
    expect(timesAfter(setInterval(program, 5, 18000))).toEqual([1000, 50, 1000, 1250, 1500, 19500]);
  });

  it('may be negative, since times may fall', () => {
    expect(timesAfter(setInterval(program, 3, -100))).toEqual([1000, 50, 1000, 900, 1150, 18000]);
  });

  it('lists the requested field also when it has that time already', () => {
    expect(valuesOf(setInterval(program, 3, 250))).toEqual([{ field: { kind: 'time', slot: 3 }, value: 1250 }]);
  });

  it.each([
    [2, 65500, 'time-out-of-range time:2'],
    [2, 65300, 'time-out-of-range time:3'],
    [1, -1, 'time-out-of-range time:1'],
    [1, 0.5, 'time-not-whole time:1'],
    [1, Number.NaN, 'time-not-whole time:1'],
  ])('of slot %i cannot be %d: %s', (slot, interval, refused) => {
    expect(refusalIn(setInterval(program, slot, interval))).toBe(refused);
  });

  it('says with a refusal what the value would have been, and its range', () => {
    expect(setInterval(program, 2, 65300)).toMatchObject({
      refused: {
        code: 'time-out-of-range',
        field: { kind: 'time', slot: 3 },
        params: { value: 65600, min: 0, max: 65535 },
      },
    });
  });

  it('has the value that was set, and the others stay as before', () => {
    fc.assert(
      fc.property(anyProgram, fc.nat(11), fc.integer({ min: -2000, max: 9000 }), (before, at, set) => {
        const { functions } = before.identity;
        const slot = 1 + (at % functions);
        const after = byOrRefused(setInterval(before, slot, set), before);
        if (!after) return;
        for (let other = 1; other <= functions; other++) {
          const kept = intervalAt(before, other);
          if (other === slot) expect(intervalAt(after, other)).toBe(set);
          else if (other < functions || slot === functions) expect(intervalAt(after, other)).toBe(kept);
        }
        if (slot < functions) expect(after.times[functions]).toBe(before.times[functions]);
        expect({ ...after, times: before.times }).toEqual(before);
      }),
      { numRuns: 500 },
    );
  });
});

describe('a shift', () => {
  it('moves this and all later functions, DT only when asked', () => {
    expect(timesAfter(shiftFrom(program, 3, 100))).toEqual([1000, 50, 1000, 1350, 1600, 18000]);
    expect(timesAfter(shiftFrom(program, 3, -100, { moveDt: true }))).toEqual([1000, 50, 1000, 1150, 1400, 17900]);
  });

  it('from DT moves DT', () => {
    expect(timesAfter(shiftFrom(program, 5, 6000))).toEqual([1000, 50, 1000, 1250, 1500, 24000]);
  });

  it('from motor stop takes along what comes at its time or later', () => {
    expect(timesAfter(shiftFrom(program, 0, 200))).toEqual([1200, 50, 1200, 1450, 1700, 18000]);
    expect(timesAfter(shiftFrom(program, 0, 200, { moveDt: true })).at(-1)).toBe(18200);
  });

  it.each([
    [3, 64200, 'time-out-of-range time:4'],
    [1, -51, 'time-out-of-range time:1'],
    [5, 0.5, 'time-not-whole time:5'],
    [3, Number.POSITIVE_INFINITY, 'time-not-whole time:3'],
    [3, 0, 'done'],
  ])('from slot %i by %d: %s', (slot, by, refused) => {
    expect(refusalIn(shiftFrom(program, slot, by))).toBe(refused);
  });

  it('is not refused for a DT that it does not move', () => {
    const late = { ...program, times: [1000, 50, 1000, 1250, 1500, 65535] };
    expect(refusalIn(shiftFrom(late, 3, 100))).toBe('done');
    expect(refusalIn(shiftFrom(late, 3, 100, { moveDt: true }))).toBe('time-out-of-range time:5');
  });

  it('back and forth changes nothing', () => {
    fc.assert(
      fc.property(
        anyProgram,
        fc.nat(12),
        fc.integer({ min: -3000, max: 3000 }),
        fc.boolean(),
        (before, at, by, moveDt) => {
          const slot = at % before.times.length;
          // There the time of the start is reserved.
          if (slot === 0 && before.identity.timerClass !== 'Q') return;
          const there = byOrRefused(shiftFrom(before, slot, slot === 0 ? Math.abs(by) : by, { moveDt }), before);
          if (!there) return;
          const back = shiftFrom(there, slot, slot === 0 ? -Math.abs(by) : -by, { moveDt });
          expect(withValues(there, valuesOf(back))).toEqual(before);
        },
      ),
      { numRuns: 1000 },
    );
  });
});

describe('a step', () => {
  const time = (slot: number): ProgramField => ({ kind: 'time', slot });
  const S1: ProgramField = { kind: 'position', servo: 0, slot: 2 };
  const E4 = { ...Q4, timerClass: 'E' };
  const stepped = (field: ProgramField, value: number, by: number, identity = Q4): number => {
    const before = withValues({ ...program, identity }, [{ field, value }]);
    return valueAt(withValues(before, valuesOf(stepValue(before, field, by))), field) as number;
  };

  it.each([
    ['a function of Q, 0.1 s', time(2), 1250, [1260, 1240, 1350, 1150], Q4],
    ['between two steps', time(2), 1255, [1260, 1250, 1350, 1160], Q4],
    ['DT, 1 s', time(5), 18000, [18100, 17900, 19000, 17000], Q4],
    ['function 2 of B, 0.01 s', time(2), 1250, [1251, 1249, 1260, 1240], B4],
    ['function 3 of B, 0.1 s', time(3), 1250, [1260, 1240, 1350, 1150], B4],
    ['where the manual says nothing, 0.01 s', time(3), 1250, [1251, 1249, 1260, 1240], E4],
    ['a position', S1, 65, [66, 64, 75, 55], Q4],
    ['a position near the end', S1, 129, [130, 128, 130, 119], Q4],
    ['a position at the end', S1, 130, [130, 129, 130, 120], Q4],
    ['a position past the end, as read', S1, 200, [200, 130, 200, 130], Q4],
    ['a position at 0', S1, 0, [1, 0, 10, 0], Q4],
    ['a typed -3', S1, -3, [0, -3, 7, -3], Q4],
    ['a time near 0', time(2), 5, [10, 0, 100, 0], Q4],
    ['the last second', time(5), 65500, [65500, 65400, 65500, 64500], Q4],
    ['past the last second', time(5), 65535, [65535, 65500, 65535, 64600], Q4],
    ['idle throttle', { kind: 'idleThrottle' } as const, 250, [251, 249, 255, 240], Q4],
  ] as const)('of %s', (_, field, value, expected, identity) => {
    expect([1, -1, 10, -10].map((by) => stepped(field, value, by, identity))).toEqual(expected);
  });

  it('does nothing to an unknown idle throttle', () => {
    expect(valuesOf(stepValue({ ...program, idleThrottle: null }, { kind: 'idleThrottle' }, 1))).toEqual([]);
  });

  it('goes in its direction, stays in range and ends on a step of the class', () => {
    fc.assert(
      fc.property(anyProgram, fc.nat(), fc.constantFrom(1, -1, 10, -10), (before, at, by) => {
        const fields = fieldsOf(before.identity);
        const field = fields[at % fields.length] as ProgramField;
        const was = valueAt(before, field);
        const values = valuesOf(stepValue(before, field, by));
        for (const { value } of values) {
          const step = field.kind === 'time' ? (manualRange(before.identity, field.slot)?.step ?? 1) : 1;
          const max = { time: 65535, position: 130, idleThrottle: 255 }[field.kind];
          expect((value - (was as number)) * by).toBeGreaterThan(0);
          expect(value >= 0 && value <= max && value % step === 0).toBe(true);
        }
        expect(values.length).toBeLessThanOrEqual(1);
      }),
      { numRuns: 500 },
    );
  });

  it('of an interval moves the function by a step, and those after it', () => {
    expect(timesAfter(stepInterval(program, 3, 1))).toEqual([1000, 50, 1000, 1260, 1510, 18000]);
    expect(timesAfter(stepInterval(program, 3, -10))).toEqual([1000, 50, 1000, 1150, 1400, 18000]);
  });

  it('of an interval ends at 0', () => {
    const close = { ...program, times: [1000, 50, 1000, 1005, 1500, 18000] };
    expect(timesAfter(stepInterval(close, 3, -10), close)).toEqual([1000, 50, 1000, 1000, 1495, 18000]);
    const falls = { ...program, times: [1000, 50, 1000, 900, 1500, 18000] };
    expect([stepInterval(falls, 3, -1), stepInterval(program, 0, 1)].map(valuesOf)).toEqual([[], []]);
  });
});

describe('a step of a range', () => {
  const range = (top: number, left: number, bottom: number, right: number) => ({ top, left, bottom, right });

  it('moves all its positions, and no others', () => {
    const after = withValues(program, valuesOf(stepRange(program, range(1, 2, 3, 3), 1)));
    expect(after).toEqual({
      ...program,
      positions: [
        [10, 21, 31, 41, 50, 60],
        [15, 26, 36, 46, 55, 65],
      ],
    });
  });

  it('moves its times and positions, but not the time of the start, which stands elsewhere', () => {
    const after = withValues(program, valuesOf(stepRange(program, range(0, 0, 2, 2), -1)));
    expect([after.times, after.positions[0]]).toEqual([
      [1000, 40, 990, 1250, 1500, 18000],
      [9, 19, 29, 40, 50, 60],
    ]);
  });

  it('of intervals spaces its functions, and those behind it follow', () => {
    expect(timesAfter(stepRange(program, range(2, 1, 3, 1), 1))).toEqual([1000, 50, 1010, 1270, 1520, 18000]);
  });

  it('is not done when one of them cannot take it', () => {
    const high = { ...program, positions: [[10, 20, 30, 130, 50, 60], program.positions[1] ?? []] };
    expect(refusalIn(stepRange(high, range(1, 2, 4, 2), 1))).toBe('position-out-of-range position:0:3');
    expect(refusalIn(stepRange(high, range(1, 2, 4, 2), -1))).toBe('done');
    expect(refusalIn(stepRange(program, range(1, 0, 2, 0), -10))).toBe('time-out-of-range time:1');
  });

  it('repeated is one step to undo', () => {
    const [one, other] = [1, -1].map((by) => stepRange(program, range(1, 2, 3, 3), by));
    expect([one?.name, one?.group]).toEqual([{ code: 'change', params: { count: 6 } }, 'step range:1,2,3,3']);
    expect(other?.group).toBe(one?.group);
    expect(stepRange(program, range(1, 2, 2, 3), 1).group).not.toBe(one?.group);
  });
});

describe('fill down', () => {
  const filled = (top: number, left: number, bottom: number, right: number): TimerProgram =>
    withValues(program, valuesOf(fillDown(program, { top, left, bottom, right })));

  it('puts the first row into the rest of the range', () => {
    expect(filled(1, 2, 3, 3).positions).toEqual([
      [10, 20, 20, 20, 50, 60],
      [15, 25, 25, 25, 55, 65],
    ]);
    expect(filled(1, 2, 3, 3).times).toEqual(program.times);
  });

  it('takes positions from the start to DT, but neither its time nor that of DT', () => {
    const after = filled(0, 0, 5, 2);
    expect(after.positions).toEqual([[10, 10, 10, 10, 10, 10], program.positions[1]]);
    expect(after.times).toEqual(program.times);
    expect(filled(3, 0, 5, 0).times).toEqual([1000, 50, 1000, 1250, 1250, 18000]);
  });

  it('spaces functions evenly from one interval', () => {
    expect(filled(1, 1, 4, 1).times).toEqual([1000, 50, 100, 150, 200, 18000]);
    expect(filled(1, 1, 3, 1).times).toEqual([1000, 50, 100, 150, 400, 18000]);
    expect(filled(0, 1, 4, 1).times).toEqual(program.times);
  });

  it('is not done where a value cannot be set', () => {
    const odd = { ...program, positions: [[10, 200, 30, 40, 50, 60], program.positions[1] ?? []] };
    const down = (left: number) => fillDown(odd, { top: 1, left, bottom: 3, right: 3 });
    expect([refusalIn(down(2)), refusalIn(down(3))]).toEqual(['position-out-of-range position:0:2', 'done']);
    const late = { ...program, times: [1000, 40000, 60000, 60100, 60200, 65000] };
    expect(refusalIn(fillDown(late, { top: 1, left: 1, bottom: 2, right: 1 }))).toBe('time-out-of-range time:2');
  });

  it.each([
    ['an interval', 1, 'time:2', 'unreadable time:2'],
    ['an interval', 1, 'time:1', 'unreadable time:1'],
    ['an interval, past what it would move', 1, 'time:4', 'unreadable time:4'],
    ['an interval', 1, 'time:5', 'done'],
    ['a time', 0, 'time:2', 'unreadable time:2'],
    ['a time', 0, 'time:1', 'done'],
    ['a position', 2, 'position:0:2', 'unreadable position:0:2'],
    ['a position', 2, 'time:2', 'done'],
  ])('copies %s (slot %i) only when it can be read: %s', (_, left, key, result) => {
    const range = { top: 2, left, bottom: 3, right: left };
    expect(refusalIn(fillDown(program, range, { unreadable: new Set([key]) }))).toBe(result);
  });

  it('of the first interval counts from launch, whatever stands at the start', () => {
    const range = { top: 1, left: 1, bottom: 2, right: 1 };
    expect(refusalIn(fillDown(program, range, { unreadable: new Set(['time:0']) }))).toBe('done');
  });

  it('twice is the same as once, and outside of the range only later times change', () => {
    fc.assert(
      fc.property(programAndRange, ([before, range]) => {
        const after = byOrRefused(fillDown(before, range), before);
        if (!after) return;
        expect(byOrRefused(fillDown(after, range), after)).toEqual(after);
        for (const field of fieldsOf(before.identity)) {
          const inside = field.kind !== 'idleThrottle' && field.slot > range.top;
          if (!inside) expect(valueAt(after, field)).toBe(valueAt(before, field));
        }
      }),
      { numRuns: 500 },
    );
  });
});

describe('every edit', () => {
  const field: ProgramField = { kind: 'time', slot: 3 };
  const name = { code: 'change', params: {} } as const;
  const range = { top: 1, left: 2, bottom: 3, right: 2 };

  it.each<[Edit, string, Record<string, unknown>, string | undefined]>([
    [stepValue(program, field, 1), 'change', { field: 'time:3' }, 'step time:3'],
    [setInterval(program, 3, 99), 'change', { slot: 3 }, 'type interval:3'],
    [stepInterval(program, 3, 1), 'change', { slot: 3 }, 'step interval:3'],
    [shiftFrom(program, 3, 100), 'shift', { slot: 3, by: 100 }, undefined],
    [fillDown(program, range), 'fill', { count: 2 }, undefined],
    [pasted(previewPaste(program, range, '65')), 'paste', { count: 3 }, undefined],
    [setValues(name, [{ field, value: 1 }], 'g'), 'change', {}, 'g'],
    [putBack(name, program, [field]), 'change', {}, undefined],
  ])('carries its name and its group: %#', (edit, code, params, group) => {
    expect([edit.name, edit.group]).toEqual([{ code, params }, group]);
  });

  it('does not count from a time whose text is not a value', () => {
    const unreadable = new Set(['time:2']);
    const all = [setInterval(program, 3, 99, { unreadable }), stepInterval(program, 3, 1, { unreadable })];
    expect(all.map(refusalIn)).toEqual(['unreadable time:2', 'unreadable time:2']);
    expect(refusalIn(setInterval(program, 1, 99, { unreadable: new Set(['time:0', 'time:1']) }))).toBe('done');
  });

  it('puts back a known value, and removes the text where none is known', () => {
    const throttle: ProgramField = { kind: 'idleThrottle' };
    const edit = putBack(name, { ...program, idleThrottle: null }, [field, throttle]);
    expect(edit).toMatchObject({ values: [{ field, value: 1250 }], texts: { 'time:3': null, idleThrottle: null } });
    expect(withValues({ ...program, times: [0, 0, 0, 0, 0, 0] }, valuesOf(replaceAll(name, program)))).toEqual(program);
  });
});
