import type { TimerProgram } from '../../program/index.js';
import { columnsIn, type GridField, type GridRange, gridField, gridValue, rowsIn } from './grid.js';
import { locale } from './locale.js';
import { areWords, isUnit } from './paste-names.js';
import { plainDigits } from './units.js';

/** How many cells of a text are read: ten times what the largest timer has. */
export const MAX_CELLS = 10_000;
/** How many characters of a text are read. */
export const MAX_CHARACTERS = 200_000;

/** A table as other programs use it: rows of texts, which may have different lengths. */
export interface Table {
  readonly rows: readonly (readonly string[])[];
  /** Whether rows are missing at the end, because the text was too long. */
  readonly cut: boolean;
}

/** A filled cell of a text. */
export interface TextCell {
  /** Its place in the text, counted from 0, headings and names of rows included. */
  readonly row: number;
  readonly column: number;
  readonly text: string;
}

/**
 * Writes a range for a spreadsheet: tabs between cells, line breaks between rows. Times and intervals are seconds with
 * two decimals, positions are steps. The decimal sign is that of the language. Intervals are left out where the range
 * also has the times.
 */
export function formatTable(program: TimerProgram, range: GridRange): string {
  const { identity } = program;
  const columns = columnsIn(identity, range);
  const rows = rowsIn(identity, range).map((row) =>
    columns.map((column) => formatCell(program, gridField(identity, { row, column }))),
  );
  return rows.map((cells) => cells.join('\t')).join('\n');
}

function formatCell(program: TimerProgram, field: GridField | null): string {
  const value = field && gridValue(program, field);
  if (value === null) return '';
  return field?.kind === 'position' ? String(value) : (value / 100).toFixed(2).replace('.', locale.value.decimal);
}

/**
 * Reads any text as a table. Cells are separated by tabs; else by semicolons; else by commas, where these cannot be
 * decimal commas. Rows end at any line break. A cell in quotation marks may contain all of these, and doubles a
 * quotation mark. White space around a cell is dropped, non-breaking kinds too. Reads whole rows, at most {@link
 * MAX_CELLS} cells and {@link MAX_CHARACTERS} characters.
 */
export function readTable(text: string): Table {
  const long = text.length > MAX_CHARACTERS;
  const read = text.slice(0, MAX_CHARACTERS).replace(/^\uFEFF/, '');
  const separator = separatorOf(read);
  const stops = new RegExp(`[${separator}\r\n]`, 'g');
  const rows: string[][] = [];
  let cells = 0;
  for (let at = 0; at < read.length; ) {
    const row: string[] = [];
    for (let more = true; more; ) {
      if (++cells > MAX_CELLS) return { rows, cut: true };
      const { cell, end } = readCell(read, at, stops);
      row.push(cell);
      more = read[end] === separator;
      at = end + (read.startsWith('\r\n', end) ? 2 : 1);
    }
    rows.push(row);
  }
  // The cut may have gone through a number, so the last row is dropped.
  if (long) rows.pop();
  return { rows, cut: long };
}

/**
 * @returns the text of the cell that begins here, and where it ends: at a separator, a line break or the end of the
 * text.
 */
function readCell(text: string, start: number, stops: RegExp): { cell: string; end: number } {
  let inMarks = '';
  let at = start;
  if (text[start] === '"') {
    const close = closingMark(text, start + 1);
    inMarks = text.slice(start + 1, close).replaceAll('""', '"');
    at = close + 1;
  }
  stops.lastIndex = at;
  const end = stops.exec(text)?.index ?? text.length;
  return { cell: (inMarks + text.slice(at, end)).trim(), end };
}

/** Where a quotation ends: at a mark that is not doubled, or else at the end of the text. */
function closingMark(text: string, start: number): number {
  let mark = text.indexOf('"', start);
  while (mark >= 0 && text[mark + 1] === '"') mark = text.indexOf('"', mark + 2);
  return mark < 0 ? text.length : mark;
}

/** A line that may be one number with a decimal comma. */
const DECIMAL_COMMA = /^-?\d*(?::\d+)?,\d+ ?(?:s|sec|min)?$/i;

function separatorOf(text: string): string {
  if (text.includes('\t')) return '\t';
  if (text.includes(';')) return ';';
  if (!text.includes(',')) return '';
  if (hasHeadings(text)) return ',';
  // As the cells are read: with all that nobody sees, and with wide digits.
  return text.split(/[\r\n]/).some((line) => DECIMAL_COMMA.test(plainDigits(line))) ? '' : ',';
}

/** Whether its first line is several headings, and each line below has as many cells: `10,60` under `Time,S1`. */
function hasHeadings(text: string): boolean {
  const [first = '', ...below] = text.split(/[\r\n]+/).filter((line) => line.trim() !== '');
  const heads = first.split(',').map((head) => head.trim());
  const isHeads = heads.length > 1 && areWords(heads) && !heads.some(isUnit);
  return isHeads && below.length > 0 && below.every((line) => line.split(',').length === heads.length);
}
