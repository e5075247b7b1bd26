import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { formatTable, MAX_CELLS, MAX_CHARACTERS, readTable } from '../../../src/app/editing/clipboard-table.js';
import { programOf } from './grid-programs.js';

const NO_BREAK = '\u00a0';
const NARROW_NO_BREAK = '\u202f';

describe('a range as text', () => {
  const program = programOf();
  const late = { ...program, times: [1000, 50, 1000, 995, 12507, 65535] };

  it('is seconds and steps, separated by tabs and line breaks', () => {
    expect(formatTable(program, { top: 0, left: 0, bottom: 2, right: 3 })).toBe(
      '10.00\t10\t15\n0.50\t20\t25\n10.00\t30\t35',
    );
  });

  it('has intervals in place of times, and none at the start', () => {
    expect(formatTable(late, { top: 0, left: 1, bottom: 5, right: 2 })).toBe(
      '\t10\n0.50\t20\n9.50\t30\n-0.05\t40\n115.12\t50\n530.28\t60',
    );
  });

  it('has two decimals', () => {
    expect(formatTable(late, { top: 3, left: 0, bottom: 5, right: 0 })).toBe('9.95\n125.07\n655.35');
    expect(formatTable(late, { top: 3, left: 1, bottom: 3, right: 1 })).toBe('-0.05');
  });

  it('ends at the edge of the grid', () => {
    expect(formatTable(program, { top: 5, left: 3, bottom: 99, right: 99 })).toBe('65');
    expect(formatTable(program, { top: 9, left: 0, bottom: 9, right: 9 })).toBe('');
  });
});

describe('a text as a table', () => {
  it.each<[what: string, text: string, rows: string[][]]>([
    ['nothing', '', []],
    ['one cell', '12.5', [['12.5']]],
    ['tabs', '1\t2\t3', [['1', '2', '3']]],
    ['line breaks of any kind', '1\n2\r\n3\r4', [['1'], ['2'], ['3'], ['4']]],
    ['a line break at the end', '1\t2\r\n', [['1', '2']]],
    ['empty rows', '1\n\n2\n\n', [['1'], [''], ['2'], ['']]],
    [
      'empty cells',
      '\t1\t\n\t',
      [
        ['', '1', ''],
        ['', ''],
      ],
    ],
    ['rows of several lengths', '1\n2\t3\n4', [['1'], ['2', '3'], ['4']]],
    ['white space around cells', ` 1 \t${NO_BREAK}2${NARROW_NO_BREAK}\n\f3`, [['1', '2'], ['3']]],
    ['white space alone', `${NO_BREAK}\t \n`, [['', '']]],
    ['a byte order mark', '\ufeff1\t2', [['1', '2']]],
    ['a byte order mark before a quotation', '\ufeff"1\t2"', [['1\t2']]],
    ['a quotation', '"1\t2"\t"3\n4"\n"5\r\n6"', [['1\t2', '3\n4'], ['5\r\n6']]],
    ['marks in a quotation', '"say ""1"""\t""""\t""', [['say "1"', '"', '']]],
    ['a quotation that goes on', '"1"2\t3', [['12', '3']]],
    ['a quotation that does not end', '"1\t2\n3', [['1\t2\n3']]],
    ['marks within a cell', '5" prop\t7"', [['5" prop', '7"']]],
    [
      'semicolons',
      '12,5;65\n13,5;70',
      [
        ['12,5', '65'],
        ['13,5', '70'],
      ],
    ],
    ['semicolons and tabs', '1;2\t3', [['1;2', '3']]],
    [
      'commas',
      '12.5,65,70\n13.5,,75',
      [
        ['12.5', '65', '70'],
        ['13.5', '', '75'],
      ],
    ],
    [
      'commas under headings',
      'Function,Time\nStart,12.5',
      [
        ['Function', 'Time'],
        ['Start', '12.5'],
      ],
    ],
    ['commas around quotations', '"12,5","65"', [['12,5', '65']]],
    ['minutes and commas', '2:05.5,65', [['2:05.5', '65']]],
    ['decimal commas', '12,5\n13,25', [['12,5'], ['13,25']]],
    ['decimal commas in minutes', '2:05,5', [['2:05,5']]],
    ['commas of which one may be decimal', '1.5,65\n 12,5 ', [['1.5,65'], ['12,5']]],
    ['an interval with a decimal comma', '-1,5', [['-1,5']]],
    ['a decimal comma behind a dash', '\u20131,5', [['\u20131,5']]],
    ['a decimal comma behind what nobody sees', '\u200e12,5\u200b', [['\u200e12,5\u200b']]],
    ['a decimal comma and a unit', '12,5 s\n2,5\u00a0min', [['12,5 s'], ['2,5\u00a0min']]],
    ['a decimal comma between wide digits', '１２,５', [['１２,５']]],
  ])('%s', (_, text, rows) => {
    expect(readTable(text)).toEqual({ rows, cut: false });
  });

  it('is read completely up to the limit of cells, and beyond it in whole rows', () => {
    const full = `${'1\t2\n'.repeat(MAX_CELLS / 2)}`;
    expect(readTable(full)).toMatchObject({ rows: { length: MAX_CELLS / 2 }, cut: false });
    const over = readTable(`${full}3`);
    expect([over.rows.length, over.cut]).toEqual([MAX_CELLS / 2, true]);
    expect(readTable('1\t'.repeat(MAX_CELLS + 1))).toEqual({ rows: [], cut: true });
  });

  it('never ends in the middle of a number', () => {
    const line = `${' '.repeat(996)}125\n`;
    expect(line.length * 200).toBe(MAX_CHARACTERS);
    const { rows, cut } = readTable(`${' '.repeat(MAX_CHARACTERS - 1002)}\n${line}`.slice(0, -1));
    expect([rows.length, cut]).toEqual([2, false]);
    const long = readTable(` ${' '.repeat(MAX_CHARACTERS - 1000)}\n${line}`);
    expect([long.rows, long.cut]).toEqual([[['']], true]);
  });

  it('is read quickly, however large or strange it is', () => {
    const pieces = [
      '\t',
      '\n',
      '"',
      '""',
      '"\t',
      ',',
      ';',
      ' ',
      '1,',
      '1,5\n',
      '\ufeff',
      '😀',
      `${'1\t'.repeat(100)}\n`,
    ];
    for (const piece of pieces) {
      const { rows, cut } = readTable(piece.repeat(Math.ceil(20e6 / piece.length)));
      expect(cut).toBe(true);
      expect(rows.flat().length).toBeLessThanOrEqual(MAX_CELLS);
    }
  });

  it('comes back as it was, quoted as spreadsheets do', () => {
    const cell = fc
      .string({ unit: fc.constantFrom('a', '1', '"', '\t', '\n', '\r', ',', ';', 'é') })
      .map((text) => text.trim());
    const table = fc
      .integer({ min: 2, max: 4 })
      .chain((width) =>
        fc.array(fc.array(cell, { minLength: width, maxLength: width }), { minLength: 1, maxLength: 5 }),
      );
    fc.assert(
      fc.property(table, fc.constantFrom('\n', '\r\n', '\r'), (rows, lineBreak) => {
        const quoted = (text: string) => (/["\t\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
        const text = rows.map((row) => row.map(quoted).join('\t')).join(lineBreak);
        expect(readTable(text)).toEqual({ rows, cut: false });
        expect(readTable(text + lineBreak).rows).toEqual(rows);
      }),
      { numRuns: 500 },
    );
  });
});
