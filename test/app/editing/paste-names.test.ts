import fc from 'fast-check';
import { h, render } from 'preact';
import { afterEach, beforeEach, describe, expect, it } from 'vitest';
import { withValues } from '../../../src/app/editing/edit.js';
import { type GridRange, gridColumns, intervalAt } from '../../../src/app/editing/grid.js';
import { pasted, previewPaste } from '../../../src/app/editing/paste.js';
import { areWords, columnNamed, rowNamed } from '../../../src/app/editing/paste-names.js';
import type { PasteAnswer } from '../../../src/app/editing/paste-questions.js';
import { formatInterval, formatTime } from '../../../src/app/editing/units.js';
import { LANGUAGES } from '../../../src/app/messages/first.js';
import { messages } from '../../../src/app/messages/index.js';
import { speak } from '../../../src/app/messages/language.js';
import { servoName } from '../../../src/app/messages/names.js';
import { ProgramGrid } from '../../../src/app/timeline/program-grid.js';
import { slotKind, type TimerProgram } from '../../../src/program/index.js';
import { slotCount } from '../../../src/protocol/index.js';
import { anyProgram, valuesOf } from './grid-programs.js';
import { sheets } from './sheets.js';

const Q10 = { timerClass: 'Q', firmware: '536', functions: 10, memories: 4, servos: 3 };

/** All times and positions differ from those of the sheets. */
const before: TimerProgram = {
  identity: Q10,
  memory: 0,
  times: [500, 1, 2, 3, 4, 5, 6, 7, 8, 9, 30000],
  positions: [1, 2, 3].map((servo) => Array.from({ length: 11 }, (_, slot) => 100 + 10 * (servo - 1) + slot)),
  idleThrottle: 30,
};

const at = (row: number, column: number): GridRange => ({ top: row, left: column, bottom: row, right: column });
const ANYWHERE = [at(0, 0), at(1, 0), at(10, 0), at(1, 1), at(4, 3), at(10, 4)];

/** What the browser copies of a program as it is printed. */
function printed(program: TimerProgram): string {
  const page = document.createElement('div');
  const columns = Array.from({ length: gridColumns(program.identity) }, (_, column) => column);
  render(h(ProgramGrid, { program, caption: '', columns }), page);
  const rows = [...page.querySelectorAll('tr')].map((row) => [...row.children].map((cell) => cell.textContent.trim()));
  return rows.map((cells) => cells.join('\t')).join('\n');
}

const answersOf = (answers: Readonly<Record<string, PasteAnswer>>) => new Map(Object.entries(answers));
const preview = (text: string, range = at(0, 0), answers: Readonly<Record<string, PasteAnswer>> = {}, on = before) =>
  previewPaste(on, range, text, { answers: answersOf(answers) });
/** What a program is once a text has been pasted; null where something is in the way. */
function result(text: string, range = at(0, 0), answers: Readonly<Record<string, PasteAnswer>> = {}, on = before) {
  const shown = preview(text, range, answers, on);
  expect(shown.problems).toEqual([]);
  return withValues(on, valuesOf(pasted(shown)));
}
const problemsIn = (text: string, range = at(0, 0), on = before) =>
  preview(text, range, {}, on).problems.map(({ row, column, text: cell, code }) => `${row}:${column} ${cell} ${code}`);
const asked = (text: string, answers: Readonly<Record<string, PasteAnswer>> = {}) =>
  preview(text, at(0, 0), answers).questions.map(({ key, answer }) => `${key} ${answer}`);

describe('a table with names', () => {
  it.each<[what: string, sheet: keyof typeof sheets, times: number[], positions: number[][]]>([
    [
      'with the row of the motor stop',
      'withMotorRow',
      [1000, 30, 120, 400, 980, 1010, 1060, 1120, 1250, 12000, 18000],
      [
        [100, 62, 64, 64, 66, 70, 70, 67, 65, 63, 63],
        [110, 44, 46, 50, 52, 30, 24, 40, 54, 56, 95],
        [120, 70, 72, 76, 78, 78, 82, 86, 88, 88, 88],
      ],
    ],
    [
      'with the row of the start',
      'withStartRow',
      [500, 30, 120, 1060],
      [
        [60, 61, 62, 70, 104],
        [15, 16, 20, 40, 114],
        [40, 41, 42, 55, 124],
      ],
    ],
    [
      'with its slots side by side',
      'transposed',
      [500, 30, 120, 1000, 1200],
      [
        [60, 61, 62, 70, 71, 105],
        [15, 16, 20, 40, 41, 115],
        [40, 41, 42, 55, 56, 125],
      ],
    ],
    [
      'as the page prints it, with all that stands around it',
      'printed',
      [1000, 1050, 1100, 1150, 1200, 1250, 1300, 1350, 1400, 1450, 18000],
      [1, 2, 3].map(() => [15, 25, 35, 45, 55, 65, 75, 85, 95, 105, 115]),
    ],
  ])('%s goes where it says, and nothing else changes', (_, sheet, times, positions) => {
    const filled = (row: readonly number[], given: readonly number[]) => [...given, ...row.slice(given.length)];
    for (const range of ANYWHERE) {
      expect(result(sheets[sheet], range)).toEqual({
        ...before,
        times: filled(before.times, times),
        positions: before.positions.map((row, servo) => filled(row, positions[servo] ?? [])),
      });
    }
  });

  it('of columns alone, with commas between them, begins at the row of the cell', () => {
    const { times, positions } = result(sheets.twoColumns, at(3, 4));
    expect(times.slice(2, 7)).toEqual([2, 1000, 1300, 1800, 6]);
    expect(positions[0]?.slice(2, 7)).toEqual([102, 60, 65, 70, 106]);
    expect(positions.slice(1)).toEqual(before.positions.slice(1));
  });

  it('is never taken for the servo of the cell', () => {
    const { positions } = result('S2\tS1\n7\t8', at(2, 2));
    expect(positions.map((row) => row[2])).toEqual([8, 7, 122]);
  });

  it.each([
    ['a servo alone', 'S2\t60\t61\t62', [1, 2, 3]],
    ['numbers of functions', 'Function\t1\t3\nS2\t60\t61', [1, 3]],
  ])('is turned with %s', (_, text, slots) => {
    const { positions } = result(text, at(1, 0));
    expect(slots.map((slot) => positions[1]?.[slot])).toEqual([60, 61, 62].slice(0, slots.length));
    expect(positions[0]).toEqual(before.positions[0]);
  });

  it('may number its functions', () => {
    for (const text of ['Function\tS1\n2\t7\n1\t8', '\tS1\n2\t7\n1\t8', 'Start\t9\n2\t7\n1\t8\nDT\t6']) {
      expect(result(text, at(0, 2)).positions[0]?.slice(1, 3), text).toEqual([8, 7]);
    }
  });

  it('in parts one below the other, with a title and notes around it, is one table', () => {
    const text =
      'calm\nM1\nFunction\tTime\tS1\nF1\t1\t7\nDT\t6:00\t8\nFunction\tTime\tS3\nF1\t1\t9\nDT\t6:00\t6\nsteps 0 to 130';
    const { times, positions } = result(text, at(5, 3));
    expect([times[1], times[10]]).toEqual([100, 36000]);
    expect(positions.map((row) => [row[1], row[10]])).toEqual([
      [7, 8],
      [111, 120],
      [9, 6],
    ]);
  });

  it('may have its minutes in the name of a row, as the tables of the page do', () => {
    expect(result('Function\tTime s\nDT min\t3:00\nFunction 9 min\t2').times.slice(9)).toEqual([12000, 18000]);
    expect(result('F9\t2').times[9]).toBe(200);
  });

  it('reads a heading with what its servo moves', () => {
    expect(result('Function\tS1 Rudder\tS2Tailplane\nF1\t7\t8').positions.map((row) => row[1])).toEqual([7, 8, 121]);
  });
});

describe('names that contradict', () => {
  it.each([
    ['a function that the timer does not have', 'Function\tS1\nF9\t7\nF10\t8', '2:0 F10 no-place'],
    ['a servo that the timer does not have', 'Function\tS1\tS4\nF9\t7\t8', '0:2 S4 no-place'],
    ['a time of the start', 'Function\tTime\nStart\t10\nF1\t0.5', '1:1 10 start'],
    ['a position of the motor stop', 'Function\tS1\nMotor stop\t7\nF1\t8', '1:1 7 no-place'],
    ['one row twice', 'Function\tS1\nF1\t7\nF1\t8', '1:1 7 twice', '2:1 8 twice'],
    ['one column twice', 'S1\tS1\n7\t8', '1:0 7 twice', '1:1 8 twice'],
    ['a column of intervals that do not fit', 'Function\tTime\tAfter\nF1\t1\t1\nF2\t2\t3', '2:2 3 interval-disagrees'],
    ['a transposed table of slots that do not exist', 'Function\tF1\tF12\nS1\t7\t8', '0:2 F12 no-place'],
  ])('are said before anything changes: %s', (_, text, ...problems) => {
    for (const range of ANYWHERE) {
      expect(problemsIn(text, range)).toEqual(problems);
    }
  });

  it('are none where both say the same', () => {
    expect(result('Function\tS1\nF1\t7\nF1\t7').positions[0]?.[1]).toBe(7);
  });

  it('include the motor stop of a timer that has none, and the reserved time', () => {
    const b: TimerProgram = { ...before, identity: { ...Q10, timerClass: 'B' } };
    expect(problemsIn('Function\tTime\nMotor stop\t10\nF1\t0.5', at(0, 0), b)).toEqual(['1:1 10 no-place']);
    expect(problemsIn('Function\tTime\nStart\t10\nF1\t0.5', at(0, 0), b)).toEqual(['1:1 10 start']);
    expect(result('Function\tTime\nStart\t0\nF1\t0.5', at(0, 0), {}, b).times.slice(0, 2)).toEqual([500, 50]);
  });
});

describe('a name that is not known', () => {
  it.each([
    ['a heading in another language', 'Zeit\n11', ['column zeit null']],
    ['several', 'Temps\tS1\tTempo\n1\t7\t2', ['column temps null', 'column tempo null']],
    ['an unknown unit of time', 'Time (ms)\tS1\n11\t7', ['column time (ms) null']],
    ['an unknown unit of positions', 'Time\tS1 (%)\n11\t7', ['column s1 (%) null']],
    ['a column without a heading', 'Time\t\n11\t7', ['column 0 1 null']],
    ['a row in another language', 'Funktion 1\t7\nArrêt moteur\t8', ['row funktion 1 null', 'row arrêt moteur null']],
    ['a row without a name', 'F1\t7\n\t8', ['row 1 0 null']],
    ['each stem once', 'Funktion 1\t7\nFunktion 2\t8\nFunktion 3\t9', ['row funktion 1 null']],
    ['a column of numbers that may be names', 'Nr\tS1\n1\t7', ['column nr null']],
  ])('is asked about, and nothing is pasted before: %s', (_, text, keys) => {
    expect(asked(text)).toEqual(keys);
    expect(valuesOf(pasted(preview(text)))).toEqual([]);
  });

  it('is not asked about without values', () => {
    expect(asked('Function\tTime\tNote\nF1\t11\t\nSumme\t\t')).toEqual([]);
  });

  it('goes where the pilot says', () => {
    const text = 'Fonction\tTemps\tServo 2\nFonction 1\t0,5\t7\nFonction 2\t1,5\t8\nArrêt moteur\t10\t\nDT\t3:00\t9';
    const answers = { 'column temps': 'time', 'row fonction 1': 'slot:1', 'row arrêt moteur': 'motor' } as const;
    const { times, positions } = result(text, at(5, 2), answers);
    expect([times.slice(0, 4), times[10]]).toEqual([[1000, 50, 150, 3], 18000]);
    expect(positions[1]?.slice(0, 4)).toEqual([110, 7, 8, 113]);
    expect(asked(text, answers)).toEqual(['column temps time', 'row fonction 1 slot:1', 'row arrêt moteur motor']);
  });

  it('may be minutes, names, or left out', () => {
    expect(result('Zeit\n0.5', at(1, 0), { 'column zeit': 'minutes' }).times[1]).toBe(3000);
    expect(result('Nr\tS1\n2\t7', at(0, 0), { 'column nr': 'names' }).positions[0]?.[2]).toBe(7);
    expect(asked('Nr\tS1\n2\t7', { 'column nr': 'names' })).toEqual(['column nr names']);
    expect(result('Summe\tS1\n2\t7', at(3, 0), { 'column summe': 'none' })).toEqual(result('S1\n7', at(3, 0)));
    expect(result('F1\t7\nSumme 1\t8\nSumme 2\t9', at(0, 2), { 'row summe 1': 'none' })).toEqual(
      result('F1\t7', at(0, 2)),
    );
  });

  it('never counts on to DT, and not to what is not there', () => {
    const problems = (text: string, answers: Readonly<Record<string, PasteAnswer>>) =>
      preview(text, at(0, 2), answers).problems.map(({ text: name, code }) => `${name} ${code}`);
    expect(problems('Funktion 9\t7\nFunktion 10\t8', { 'row funktion 9': 'slot:9' })).toEqual(['Funktion 10 no-place']);
    expect(problems('Zeile 2\t7\nZeile 1\t8', { 'row zeile 2': 'slot:0' })).toEqual(['Zeile 1 no-place']);
    expect(problems('Canal 2\tCanal 1\n7\t8', { 'column canal 2': 'servo:0' })).toEqual(['Canal 1 no-place']);
  });
});

describe.each(LANGUAGES)("the page's own words in %s", (language) => {
  beforeEach(() => speak(language));
  afterEach(() => speak('en'));

  it('are known', () => {
    const { program, edits, times } = messages.value;
    for (const slot of Array.from({ length: 11 }, (_, each) => each)) {
      const kind = slotKind(Q10, slot);
      for (const name of [messages.value.slotName({ slot, kind }), messages.value.slotShort({ slot, kind })]) {
        expect(rowNamed(Q10, name, true), name).toEqual({ slot });
      }
    }
    for (const name of [program.motorStop, program.motor]) expect(rowNamed(Q10, name, false)).toBe('motor');
    expect(areWords([messages.value.slotName({ slot: 3, kind: 'function' }), program.motorStop])).toBe(true);
    expect(columnNamed(program.slot)).toBe('names');
    expect(columnNamed(`${program.time}\u00a0${times.units.s}`)).toEqual({ column: 0, inMinutes: false });
    expect(columnNamed(edits.table.interval)).toMatchObject({ column: 1 });
    expect([0, 7].map((servo) => columnNamed(servoName(servo)))).toMatchObject([{ column: 2 }, { column: 9 }]);
  });

  it('bring a table that was printed back to where it was', () => {
    const program: TimerProgram = { ...before, times: before.times.map((time, slot) => time + 1250 * slot) };
    const text = printed(program);
    for (const range of ANYWHERE) expect(result(text, range)).toEqual({ ...program, idleThrottle: 30 });
  });
});

describe('the usual short forms', () => {
  it.each([
    ...['F3', 'f 3', 'Fn. 3', 'FUNC 03', 'Function\u00a03:', '3. function', 'Ｆ３'].map((name) => [name, 3] as const),
    ...['Start', 'launch'].map((name) => [name, 0] as const),
    ...['DT', 'D/T', 'Dethermaliser'].map((name) => [name, 10] as const),
  ])('are known, too: %s', (name, slot) => {
    expect(rowNamed(Q10, name, false)).toEqual({ slot });
  });

  it.each(['F', 'M1', 'S1', 'Function', 'F0', 'Stop', 'F1 old', '1'])('but not %s', (name) => {
    expect(rowNamed(Q10, name, false)).toBe('unknown');
  });
});

/** Any order of these. */
const shuffled = <T>(list: readonly T[]): fc.Arbitrary<T[]> =>
  fc.shuffledSubarray([...list], { minLength: list.length, maxLength: list.length });

describe('any program', () => {
  const settable = anyProgram.map(
    (program): TimerProgram => ({
      ...program,
      positions: program.positions.map((row) => row.map((position) => position % 131)),
    }),
  );
  const layout = settable.chain((program) => {
    const slots = Array.from({ length: slotCount(program.identity) }, (_, slot) => slot);
    return fc.record({
      program: fc.constant(program),
      rows: shuffled([...slots.map(String), ...(program.identity.timerClass === 'Q' ? ['motor'] : [])]),
      columns: shuffled(['names', 'time', 'after', ...program.positions.keys()]),
      isTurned: fc.boolean(),
      separator: fc.constantFrom('\t', ';', ','),
      range: fc.tuple(fc.nat(9), fc.nat(5)).map(([row, column]) => at(row, column)),
      short: fc.boolean(),
    });
  });

  it('written as a sheet, in any order of rows and columns, pastes back to exactly that program', () => {
    fc.assert(
      fc.property(layout, ({ program, rows, columns, isTurned, separator, range, short }) => {
        const { identity } = program;
        const words = messages.value;
        const cellOf = (row: string, column: string | number): string => {
          const slot = Number(row);
          const isMotor = row === 'motor';
          if (column === 'names') {
            const name = short ? words.slotShort : words.slotName;
            return isMotor ? words.program.motorStop : name({ slot, kind: slotKind(identity, slot) });
          }
          if (column === 'time') {
            return isMotor
              ? formatTime(program.times[0] ?? 0)
              : slot === 0
                ? '0'
                : formatTime(program.times[slot] ?? 0);
          }
          const interval = isMotor ? null : intervalAt(program, slot);
          if (column === 'after') return interval === null ? '' : formatInterval(interval);
          return isMotor ? '' : String(program.positions[Number(column)]?.[slot]);
        };
        const headOf = (column: string | number): string =>
          column === 'names'
            ? words.program.slot
            : column === 'time'
              ? words.program.time
              : column === 'after'
                ? words.edits.table.interval
                : servoName(Number(column));
        const table = [columns.map(headOf), ...rows.map((row) => columns.map((column) => cellOf(row, column)))];
        // A transposed table has its headings first.
        const first = columns.indexOf('names');
        const turned = columns.map((_, column) => table.map((texts) => texts[column] ?? ''));
        const heads = turned.splice(first, 1);
        const text = (isTurned ? [...heads, ...turned] : table).map((texts) => texts.join(separator)).join('\n');
        // Only what can be set counts: the reserved time of other classes stays.
        const reserved = identity.timerClass === 'Q' ? 0 : (program.times[0] ?? 0);
        const empty: TimerProgram = {
          ...program,
          times: program.times.map((_, slot) => (slot === 0 ? reserved : 0)),
          positions: program.positions.map((row) => row.map(() => 0)),
        };
        const shown = previewPaste(empty, range, text);
        expect({ ...shown, changes: [], values: [], cells: [], readings: [] }).toEqual({
          ...{ changes: [], values: [], cells: [], readings: [] },
          ...{ problems: [], questions: [] },
        });
        expect(withValues(empty, valuesOf(pasted(shown)))).toEqual(program);
      }),
      { numRuns: 1000 },
    );
  });

  it('as it is printed pastes back to exactly that program', () => {
    fc.assert(
      fc.property(settable, (program) => {
        const shown = previewPaste(program, at(1, 0), printed(program));
        expect([shown.problems, shown.questions, shown.changes]).toEqual([[], [], []]);
      }),
    );
  });
});
