import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { formatTable } from '../../../src/app/editing/clipboard-table.js';
import { refusalOf, withValues } from '../../../src/app/editing/edit.js';
import { setInterval } from '../../../src/app/editing/edits.js';
import { fieldsIn, type GridRange, intervalAt, programField } from '../../../src/app/editing/grid.js';
import { type PasteOptions, type PastePreview, pasted, previewPaste } from '../../../src/app/editing/paste.js';
import { differences, fieldKey, type TimerProgram } from '../../../src/program/index.js';
import { anyProgram, programAndRange, programOf, Q4, valuesOf } from './grid-programs.js';

const program = programOf();
const B4 = { ...Q4, timerClass: 'B' };

/** The range of one cell. */
const at = (row: number, column: number): GridRange => ({ top: row, left: column, bottom: row, right: column });
const changesIn = ({ changes }: PastePreview) =>
  Object.fromEntries(changes.map(({ field, from, to }) => [fieldKey(field), `${from} -> ${to}`]));
const problemsIn = ({ problems }: PastePreview) =>
  problems.map(({ row, column, text, code }) => `${row}:${column} ${text} ${code}`);

function paste(text: string, range = at(0, 0), options: PasteOptions = {}, before = program): PastePreview {
  return previewPaste(before, range, text, options);
}

const setBy = (preview: PastePreview) => valuesOf(pasted(preview));

describe('a pasted table', () => {
  it('begins at the first cell and says what changes', () => {
    const preview = paste('12,5\t65\n2:05.5\t40', at(3, 0));
    expect(changesIn(preview)).toEqual({
      'position:0:3': '40 -> 65',
      'position:0:4': '50 -> 40',
      'time:4': '1500 -> 12550',
    });
    expect(preview).toMatchObject({ problems: [], questions: [] });
    expect(withValues(program, setBy(preview)).times).toEqual([1000, 50, 1000, 1250, 12550, 18000]);
  });

  it('changes nothing under empty cells', () => {
    expect(changesIn(paste('\t\t66\n\t21\t\n', at(0, 0)))).toEqual({
      'position:1:0': '15 -> 66',
      'position:0:1': '20 -> 21',
    });
  });

  it('says of each value past the edge that it has no place', () => {
    const wide = Array.from({ length: 100 }, (_, column) => (column === 50 ? '' : '7')).join('\t');
    const preview = paste(`${wide}\n8`, at(5, 2));
    expect([changesIn(preview), problemsIn(preview).length]).toEqual([
      { 'position:0:5': '60 -> 7', 'position:1:5': '65 -> 7' },
      98,
    ]);
    expect(problemsIn(paste('1\t2', at(0, 1)))).toEqual(['0:0 1 no-place']);
    expect(problemsIn(paste('1', at(0, 1)))).toEqual(['0:0 1 no-place']);
  });

  it('at the time column has no intervals, unless it is as wide as the grid', () => {
    expect(changesIn(paste('12\t1\t2', at(3, 0)))).toEqual({
      'time:3': '1250 -> 1200',
      'position:0:3': '40 -> 1',
      'position:1:3': '45 -> 2',
    });
    expect(changesIn(paste('Function 3\t12\t2\t1\t2', at(3, 0)))).toEqual({
      'time:3': '1250 -> 1200',
      'position:0:3': '40 -> 1',
      'position:1:3': '45 -> 2',
    });
  });

  it('of one cell fills the range, each field in its way', () => {
    const preview = paste('12', { top: 2, left: 0, bottom: 3, right: 2 });
    expect(changesIn(preview)).toEqual({
      'time:2': '1000 -> 1200',
      'time:3': '1250 -> 1200',
      'position:0:2': '30 -> 12',
      'position:0:3': '40 -> 12',
    });
    expect(problemsIn(paste('x', { top: 2, left: 2, bottom: 3, right: 3 }))).toEqual(['0:0 x not-a-whole-number']);
    expect(paste('', { top: 2, left: 0, bottom: 3, right: 2 })).toMatchObject({ values: [], problems: [] });
  });

  it('lists a value also when it is the same as before', () => {
    const preview = paste('20', at(1, 2));
    expect([preview.changes, setBy(preview).length]).toEqual([[], 1]);
  });
});

describe('headings and names', () => {
  it.each([
    ['a text alone', 'Time', '0:0 Time not-a-time'],
    ['what stands for a number', 'NaN\n11', '0:0 NaN not-a-time'],
    ['an error', '#REF!\n11', '0:0 #REF! not-a-time'],
    ['an error of LibreOffice', 'Err:502\n11', '0:0 Err:502 not-a-time'],
    [
      'a column of such errors',
      'Err:502\t7\nErr\u00a0:508\t8',
      '0:0 Err:502 not-a-time',
      '1:0 Err\u00a0:508 not-a-time',
    ],
    ['a formula', '=A1\n11', '0:0 =A1 not-a-time'],
    ['a row of texts alone', 'Start\tTime\tS1', '0:1 Time start', '0:2 S1 not-a-whole-number'],
    ['a column of texts', 'Time\nStart\nDT', '1:0 Start not-a-time', '2:0 DT not-a-time'],
    ['a name among numbers', 'x\t1\n11\t2', '0:0 x not-a-time'],
  ])('%s is not a heading', (_, text, ...problems) => {
    expect(problemsIn(paste(text))).toEqual(problems);
  });

  it.each(['Time s', 'Time (s)', 'time[s]', 'Time\u00a0s'])('may name the unit: “%s”', (heading) => {
    const preview = paste(`S1\t${heading}\n7\t11`, at(0, 0));
    expect(changesIn(preview)).toEqual({ 'time:0': '1000 -> 1100', 'position:0:0': '10 -> 7' });
    expect(preview).toMatchObject({ problems: [] });
  });

  it.each(['s\tsteps', '(s)\t', '\t[steps]', 'sec.\tUnits'])('may have a row of units below them: “%s”', (units) => {
    const preview = paste(`Time\tS1\n${units}\n11\t7\nx\t8`, at(0, 0));
    expect(changesIn(preview)).toEqual({
      'time:0': '1000 -> 1100',
      'position:0:0': '10 -> 7',
      'position:0:1': '20 -> 8',
    });
    expect(preview).toMatchObject({ questions: [] });
    expect(preview.problems.map(({ code, row }) => [code, row])).toEqual([['not-a-time', 3]]);
  });

  it.each(['min', '(min.)', '[Min]'])('may have minutes in that row: “%s”', (unit) => {
    const preview = paste(`S1\tTime\nsteps\t${unit}\n7\t0.5\n8\t0:40\n9\tx\n\t2.30\n\t3 s`, at(1, 0));
    expect(changesIn(preview)).toMatchObject({
      'time:1': '50 -> 3000',
      'time:2': '1000 -> 4000',
      'time:4': '1500 -> 13800',
      'position:0:1': '20 -> 7',
    });
    expect(problemsIn(preview)).toEqual(['4:1 x min not-a-time', '6:1 3 s min not-a-time']);
    expect(preview.readings.map(({ text, value }) => [text, value])).toEqual([['2.30 min', 13800]]);
  });

  it('have no row of units below them that holds anything else', () => {
    const preview = paste('Function\tTime\tS1\nStart\ts\tsteps\nDT\t11\t7', at(0, 0));
    expect(preview.problems.map(({ row, column }) => [row, column])).toEqual([
      [1, 1],
      [1, 2],
    ]);
  });

  it('do not change how places in the text are counted', () => {
    expect(problemsIn(paste('Function\tTime\nF1\tx\nF2\t1\nF3\t-1'))).toEqual([
      '1:1 x not-a-time',
      '3:1 -1 not-a-time',
    ]);
  });
});

describe('a cell that is wrong', () => {
  it.each([
    ['-1', 0, 'not-a-time'],
    ['12 5', 0, 'not-a-time'],
    ['2.05.5', 0, 'not-a-time'],
    ['1.234.567', 0, 'not-a-time'],
    ['12.345', 0, 'too-fine'],
    ['655.36', 0, 'time-out-of-range'],
    ['1.5', 2, 'not-a-whole-number'],
    ['131', 2, 'position-out-of-range'],
    ['-1', 2, 'position-out-of-range'],
  ])('%j is no value of column %i: %s', (text, column, code) => {
    expect(problemsIn(paste(text, at(3, column)))).toEqual([`0:0 ${text} ${code}`]);
  });

  it('does not stop the rest', () => {
    const preview = paste('1\t2\nx\t200', at(2, 2));
    expect(problemsIn(preview)).toEqual(['1:0 x not-a-whole-number', '1:1 200 position-out-of-range']);
    expect(changesIn(preview)).toEqual({ 'position:0:2': '30 -> 1', 'position:1:2': '35 -> 2' });
    expect(differences(program, withValues(program, setBy(preview)))).toEqual(preview.changes);
  });

  it('is reported with its place, its range and the beginning of its text', () => {
    const { problems } = paste(`200\n${'9'.repeat(1000)}`, at(2, 3));
    expect(problems[0]).toEqual({
      code: 'position-out-of-range',
      params: { min: 0, max: 130 },
      row: 0,
      column: 0,
      text: '200',
      field: { kind: 'position', servo: 1, slot: 2 },
    });
    expect(problems[1]?.text.length).toBeLessThan(100);
  });

  it('does not include a value that the timer holds already, though it could not be set', () => {
    const odd: TimerProgram = { ...program, positions: [[200, 20, 30, 40, 50, 60], program.positions[1] ?? []] };
    expect(paste('200', at(0, 2), {}, odd)).toMatchObject({ changes: [], problems: [] });
    expect(problemsIn(paste('200', at(1, 2), {}, odd))).toEqual(['0:0 200 position-out-of-range']);
  });

  it('includes one that would change a reserved time', () => {
    const b: TimerProgram = { ...program, identity: B4 };
    expect(problemsIn(paste('11\n0.6', at(0, 0), {}, b))).toEqual(['0:0 11 start']);
    expect(changesIn(paste('10\n0.6', at(0, 0), {}, b))).toEqual({ 'time:1': '50 -> 60' });
    expect(problemsIn(paste('7\n8', at(0, 2), {}, b))).toEqual([]);
  });

  it('includes the end of a text that is too large', () => {
    const preview = paste(`${'1\t2\n'.repeat(5000)}3`, at(0, 2));
    expect(problemsIn(preview).slice(0, 2)).toEqual(['5000:0  too-large', '6:0 1 no-place']);
    expect(setBy(preview)).toHaveLength(12);
    expect(paste(`7\n${'x'.repeat(300_000)}`, { top: 0, left: 2, bottom: 5, right: 3 }).changes).toHaveLength(1);
  });
});

describe('pasted intervals', () => {
  const times = (preview: PastePreview) => withValues(program, setBy(preview)).times;

  it('are set from top to bottom; rows without one keep their distance, and DT its time', () => {
    expect(times(paste('1\n2', at(1, 1)))).toEqual([1000, 100, 300, 550, 800, 18000]);
    expect(times(paste('\n1\n\n2', at(0, 1)))).toEqual([1000, 100, 1050, 1250, 1500, 18000]);
    expect(times(paste('1\n100', at(4, 1)))).toEqual([1000, 50, 1000, 1250, 1350, 11350]);
    expect(times(paste('-1', at(3, 1)))).toEqual([1000, 50, 1000, 900, 1150, 18000]);
  });

  it('may lead through impossible times', () => {
    expect(times(paste('650\n-640', at(2, 1)))).toEqual([1000, 50, 65050, 1050, 1300, 18000]);
    expect(times(paste('655\n-654', at(3, 1)))).toEqual(program.times);
    expect(times(paste('644\n-640', at(3, 1)))).toEqual([1000, 50, 1000, 65400, 1400, 18000]);
  });

  it('that would carry a function out of range are refused, and the rest goes on without them', () => {
    const own = paste('1\n700\n2', at(1, 1));
    expect(problemsIn(own)).toEqual(['1:0 700 time-out-of-range']);
    expect(times(own)).toEqual([1000, 100, 1050, 1250, 1500, 18000]);
    expect(problemsIn(paste('700\nx', at(1, 1)))).toEqual(['0:0 700 time-out-of-range', '1:0 x not-a-time']);
    const later = paste('1\n654', at(1, 1));
    expect(problemsIn(later)).toEqual(['1:0 654 later-out-of-range']);
    expect(times(later)).toEqual([1000, 100, 1050, 1300, 1550, 18000]);
  });

  it('beside times must agree with them', () => {
    expect(problemsIn(paste('0.5\t0.5\t7\t7\n10\t9.5\t7\t7', at(1, 0)))).toEqual([]);
    const preview = paste('0.6\t0.5\t7\t7\n10\t9.4\t7\t7', at(1, 0));
    expect(problemsIn(preview)).toEqual(['0:1 0.5 interval-disagrees']);
    expect(times(preview)).toEqual([1000, 60, 1000, 1250, 1500, 18000]);
  });

  it('count in rows without a readable time', () => {
    expect(times(paste('-1\t0.6\t7\t7', at(1, 0)))).toEqual([1000, 60, 1010, 1260, 1510, 18000]);
    expect(times(paste('0.6\t\t7\t7\n\t9\t7\t7', at(1, 0)))).toEqual([1000, 60, 960, 1210, 1460, 18000]);
  });

  it('give the same as setting them one by one', () => {
    const input = anyProgram.chain((before) =>
      fc.tuple(
        fc.constant(before),
        fc.array(fc.option(fc.integer({ min: -500, max: 4000 })), {
          minLength: 1,
          maxLength: before.identity.functions,
        }),
      ),
    );
    let compared = 0;
    fc.assert(
      fc.property(input, ([before, intervals]) => {
        let expected = before;
        for (const [index, interval] of intervals.entries()) {
          if (interval === null) continue;
          const edit = setInterval(expected, index + 1, interval);
          if ('refused' in edit) return;
          expected = withValues(expected, edit.values);
        }
        const text = intervals.map((interval) => (interval === null ? '' : (interval / 100).toFixed(2))).join('\n');
        const range = intervals.length === 1 ? at(1, 1) : { ...at(1, 1), bottom: 99 };
        const preview = previewPaste(before, range, `${text}\n`);
        expect(preview.problems).toEqual([]);
        expect(withValues(before, setBy(preview))).toEqual(expected);
        compared++;
      }),
      { numRuns: 500 },
    );
    expect(compared).toBeGreaterThan(100);
  });
});

describe('copied and pasted', () => {
  const decimal = fc.constantFrom<'.' | ','>('.', ',');

  it('on the same range changes nothing', () => {
    fc.assert(
      fc.property(programAndRange, decimal, ([before, range], mark) => {
        const preview = previewPaste(before, range, formatTable(before, range).replaceAll('.', mark));
        expect(preview).toMatchObject({ changes: [], problems: [], questions: [] });
        const fields = new Set(fieldsIn(before.identity, range).map((field) => fieldKey(programField(field))));
        expect(new Set(preview.values.map(({ field }) => fieldKey(field)))).toEqual(fields);
      }),
      { numRuns: 1000 },
    );
  });

  it('into another program copies the range, except values that cannot be set', () => {
    fc.assert(
      fc.property(programAndRange, anyProgram, decimal, ([source, range], other, mark) => {
        const target = {
          ...source,
          times: source.times.map((_, column) => other.times[column % other.times.length] as number),
          positions: source.positions.map((row) => row.map((_, column) => other.positions[0]?.[column % 2] as number)),
        };
        const preview = previewPaste(target, range, formatTable(source, range).replaceAll('.', mark));
        const after = withValues(target, setBy(preview));
        if (preview.problems.length > 0) return;
        for (const field of fieldsIn(source.identity, range)) {
          if (field.kind === 'interval') expect(intervalAt(after, field.slot)).toBe(intervalAt(source, field.slot));
        }
        expect(formatTable(after, range)).toBe(formatTable(source, range));
      }),
      { numRuns: 1000 },
    );
  });
});

describe('whatever is pasted', () => {
  const piece = fc.constantFrom(
    ...[
      '\t',
      '\t',
      '\n',
      '\n',
      '\r\n',
      '"',
      ',',
      ';',
      '.',
      ':',
      '-',
      '0',
      '1',
      '65',
      '12.5',
      '12,5',
      '2:05',
      '131',
      ' ',
    ],
    ...[
      '=1+1',
      '1e309',
      'NaN',
      '#REF!',
      'Time',
      'S1',
      'Interval',
      'Start',
      '\u00a0',
      '\ufeff',
      '\u2028',
      '😀',
      '\ud800',
      '\u0000',
    ],
  );
  const cell = fc.oneof(
    { weight: 6, arbitrary: fc.nat(140).map(String) },
    { weight: 4, arbitrary: fc.integer({ min: -300, max: 9000 }).map((time) => (time / 100).toFixed(2)) },
    { weight: 2, arbitrary: fc.constant('') },
    { weight: 1, arbitrary: fc.string({ unit: piece, maxLength: 3 }) },
  );
  const table = fc
    .array(fc.array(cell, { minLength: 1, maxLength: 6 }), { minLength: 1, maxLength: 14 })
    .map((rows) => rows.map((cells) => cells.join('\t')).join('\n'));
  const anyText = fc.oneof(table, fc.string({ unit: piece, maxLength: 60 }), fc.string({ unit: 'binary' }));

  it('the preview says exactly what is applied, and that can be written and lies in the grid', () => {
    let changed = 0;
    fc.assert(
      fc.property(programAndRange, anyText, ([before, range], text) => {
        const copy = structuredClone(before);
        const preview = previewPaste(before, range, text);
        const values = setBy(preview);
        const after = withValues(before, values);
        expect(before).toEqual(copy);
        expect(differences(before, after)).toEqual(preview.questions.length === 0 ? preview.changes : []);
        expect(new Set(values.map(({ field }) => fieldKey(field))).size).toBe(values.length);
        for (const { field, to } of preview.changes) {
          if (field.kind === 'idleThrottle') expect.fail('the idle throttle is not in the grid');
          else expect(refusalOf(field, to as number)).toBeNull();
        }
        const { timerClass } = before.identity;
        if (timerClass !== 'Q') expect(after.times[0]).toBe(before.times[0]);
        expect(preview.problems.every(({ row }) => row < text.split(/[\r\n]/).length)).toBe(true);
        if (preview.questions.length > 0) expect(values).toEqual([]);
        if (preview.changes.length > 0) changed++;
      }),
      { numRuns: 3000 },
    );
    expect(changed).toBeGreaterThan(500);
  });

  it.each([
    ['counts from it', '2', at(3, 1), 'time:2', ['0:0 2 unreadable']],
    ['would move it', '2', at(3, 1), 'time:4', ['0:0 2 unreadable']],
    ['replaces it', '2', at(3, 1), 'time:3', []],
    ['moves nothing', '2.5', at(3, 1), 'time:4', []],
    ['is DT', '2', at(3, 1), 'time:5', []],
    ['counts from launch', '2', at(1, 1), 'time:0', []],
    ['counts from a time that is pasted, too', '1\n2', at(2, 1), 'time:2', []],
    ['counts from an impossible time', '999\n2', at(2, 1), 'time:2', ['0:0 999 time-out-of-range', '1:0 2 unreadable']],
    ['stands beside a time', '14\t2\t1\t1', at(3, 0), 'time:2', ['0:1 2 unreadable']],
    ['stands below a time', '11\t\t1\t1\n\t2\t1\t1', at(2, 0), 'time:2', []],
  ])('an interval and a text that is not a value: it %s', (_, text, range, key, problems) => {
    expect(problemsIn(paste(text, range, { unreadable: new Set([key]) }))).toEqual(problems);
  });

  it('is refused or done quickly, with thousands of columns and rows', () => {
    for (const text of [`${'1\t'.repeat(99)}1\n`.repeat(1e5), '65\n'.repeat(1e6), 'x'.repeat(5e6), '"'.repeat(5e6)]) {
      const preview = paste(text, at(0, 2));
      expect(preview.problems[0]?.code).toBe('too-large');
    }
  });
});
