import {
  type Change,
  differences,
  type FindingCode,
  fieldKey,
  type TimerProgram,
  valueAt,
} from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { MAX_CELLS, MAX_CHARACTERS, readTable } from './clipboard-table.js';
import { type Edit, type FieldValue, MAX_VALUE, refusalOf, setValues, type TextOption, withValues } from './edit.js';
import { retime, startOf } from './edits.js';
import {
  columnsIn,
  fieldsIn,
  type GridField,
  type GridRange,
  gridColumns,
  gridField,
  intervalAt,
  TIME_COLUMN,
} from './grid.js';
import type { StepName } from './history.js';
import { type Parsed, parseInterval, parseSteps, parseTime, readInterval, type UnreadableReason } from './units.js';

/**
 * What may be wrong with a pasted cell.
 *
 * - `not-a-time`, `too-fine`, `not-a-whole-number`: it is not a value.
 * - `time-out-of-range`, `position-out-of-range` (min, max): the wire cannot carry it.
 * - `later-out-of-range` (min, max): its interval would move a later function to where the wire cannot carry it.
 * - `before-unreadable`: its interval counts from a time that is not pasted, and whose text is not a value.
 * - `later-unreadable`: its interval would move a later function whose text is not a value.
 * - `interval-disagrees`: the row has a time too, and this is not the interval that follows from the times.
 * - `reserved`: slot 0 of a class other than Q is edited only as a field of its own.
 * - `too-large` (cells, characters): the rest of the text from this row on was not read.
 */
export type PasteProblemCode =
  | Exclude<UnreadableReason, 'empty' | 'ambiguous'>
  | Extract<FindingCode, 'time-out-of-range' | 'position-out-of-range'>
  | 'later-out-of-range'
  | 'before-unreadable'
  | 'later-unreadable'
  | 'interval-disagrees'
  | 'reserved'
  | 'too-large';

export interface PasteProblem {
  readonly code: PasteProblemCode;
  readonly params: Readonly<Record<string, number>>;
  /** Where it stands in the text that was pasted, counted from 0 with headings and names. */
  readonly row: number;
  readonly column: number;
  /** What stands there, not all of it if it is long. */
  readonly text: string;
  /** Where it was to go; of a cell that was to go to several, the first that could not take it. */
  readonly field: GridField | null;
}

/** A pasted text that a pilot could have typed for something else. Tables are taken at their word: it is seconds. */
export interface PasteReading {
  readonly field: GridField;
  readonly text: string;
  /** Hundredths of a second. */
  readonly value: number;
}

/**
 * What a text would do to a program. Nothing is done if there is a problem, unless the rest is taken on purpose: see
 * {@link pasted}.
 */
export interface PastePreview {
  /** What would change. */
  readonly changes: readonly Change[];
  /** What would be set, changed or not. */
  readonly values: readonly FieldValue[];
  /** Row by row. */
  readonly problems: readonly PasteProblem[];
  /** How texts are read that would be asked about where they are typed, row by row. */
  readonly readings: readonly PasteReading[];
  /**
   * How many cells with something in them have no place: past the edge of the grid, or under a heading of something
   * else.
   */
  readonly ignored: number;
  /** The first row was taken for headings. */
  readonly headings: boolean;
  /** The first column was taken for names of rows. */
  readonly names: boolean;
}

export interface PasteOptions extends TextOption {
  /**
   * What the columns of the grid are called, time first. A table pasted at the time column under such headings goes
   * where they say.
   */
  readonly headings?: readonly string[];
}

/** A cell with something in it, and where it goes. */
interface Pasted {
  readonly row: number;
  readonly column: number;
  readonly text: string;
  readonly field: GridField;
}

const LONGEST_TEXT = 60;

/**
 * What pasting a text at a range would do. The text begins at the first cell of the range and may go beyond the range;
 * a single cell fills all of the range. Empty cells leave what is there. At the time column a table is taken to have no
 * intervals, unless it is as wide as the grid. Where a row has both, its time counts and the interval must agree; else
 * intervals are set from top to bottom, and functions without a cell keep their distance to the one above.
 */
export function previewPaste(
  program: TimerProgram,
  range: GridRange,
  text: string,
  { headings = [], unreadable }: PasteOptions = {},
): PastePreview {
  const { rows, cut } = readTable(text);
  const isSingle = !cut && rows.length === 1 && rows[0]?.length === 1;
  const { cells, ...read } = isSingle
    ? fill(program.identity, range, rows[0]?.[0] ?? '')
    : place(program.identity, range, rows, headings);
  const { values, problems } = resolve(program, cells, { unreadable });
  if (cut) {
    const params = { cells: MAX_CELLS, characters: MAX_CHARACTERS };
    problems.push({ code: 'too-large', params, row: rows.length, column: 0, text: '', field: null });
  }
  const readings = cells.flatMap((cell) => readingOf(program.identity, cell));
  return { changes: differences(program, withValues(program, values)), values, problems, readings, ...read };
}

/**
 * The edit that a paste is.
 * @param takeRest the pilot has seen the problems and wants what can be read anyway.
 */
export function pasted({ changes, values, problems }: PastePreview, takeRest = false): Edit {
  const name: StepName = { code: 'paste', params: { count: changes.length } };
  return setValues(name, problems.length === 0 || takeRest ? values : []);
}

interface Placed extends Pick<PastePreview, 'ignored' | 'headings' | 'names'> {
  readonly cells: readonly Pasted[];
}

function fill(identity: Identity, range: GridRange, text: string): Placed {
  const fields = text === '' ? [] : fieldsIn(identity, range);
  const cells = fields.map((field) => ({ row: 0, column: 0, text, field }));
  return { cells, ignored: text !== '' && fields.length === 0 ? 1 : 0, headings: false, names: false };
}

function place(
  identity: Identity,
  { top, left }: GridRange,
  rows: readonly (readonly string[])[],
  known: readonly string[],
): Placed {
  const headings = rows.length > 1 && areWords(rows[0] ?? []);
  const body = headings ? rows.slice(1) : rows;
  const width = Math.max(0, ...rows.map(lengthOf));
  const names = width > 1 && areWords(body.map(([first = '']) => first));
  const first = names ? 1 : 0;
  const across = acrossFrom(identity, left, width - first);
  const byName = headings && left === TIME_COLUMN ? columnsByName(rows[0] ?? [], known) : null;
  const cells: Pasted[] = [];
  let ignored = 0;
  for (const [at, texts] of body.entries()) {
    for (const [column, text] of texts.entries()) {
      if (text === '' || column < first) continue;
      const target = (byName ? byName[column] : across[column - first]) ?? -1;
      const field = gridField(identity, { row: top + at, column: target });
      if (field) cells.push({ row: headings ? at + 1 : at, column, text, field });
      else ignored++;
    }
  }
  return { cells, ignored, headings, names };
}

/** How long a row is without the empty cells at its end. */
function lengthOf(texts: readonly string[]): number {
  return texts.reduce((length, text, at) => (text === '' ? length : at + 1), 0);
}

/** The columns of the grid that a table of this width goes to. */
function acrossFrom(identity: Identity, left: number, width: number): number[] {
  const right = gridColumns(identity) - 1;
  const all = width === gridColumns(identity) && left === TIME_COLUMN;
  return all
    ? Array.from({ length: width }, (_, column) => column)
    : columnsIn(identity, { top: 0, bottom: 0, left, right });
}

/**
 * The columns of the grid that stand under their names, -1 for others; null where no name is known or one comes twice.
 */
function columnsByName(texts: readonly string[], known: readonly string[]): number[] | null {
  const plain = (text: string): string => text.trim().toLowerCase();
  const names = known.map(plain);
  const columns = texts.map((text) => (text === '' ? -1 : names.indexOf(plain(text))));
  const found = columns.filter((column) => column >= 0);
  return found.length > 0 && new Set(found).size === found.length ? columns : null;
}

const WORD = /^(?!(?:nan|inf|infinity)$)\p{L}/iu;

/**
 * Whether these are headings or names: there are some, and each begins with a letter. What spreadsheets say in place of
 * a number is no word.
 */
function areWords(texts: readonly string[]): boolean {
  const some = texts.filter((text) => text !== '');
  return some.length > 0 && some.every((text) => WORD.test(text));
}

/** What the cells set, and which of them cannot be. */
function resolve(
  program: TimerProgram,
  cells: readonly Pasted[],
  texts: TextOption,
): { values: FieldValue[]; problems: PasteProblem[] } {
  const problems: PasteProblem[] = [];
  const refuse = (cell: Pasted, code: PasteProblemCode, params: PasteProblem['params'] = {}): void => {
    const { row, column } = cell;
    if (problems.some((known) => known.row === row && known.column === column && known.code === code)) return;
    problems.push({ ...cell, code, params, text: cell.text.slice(0, LONGEST_TEXT) });
  };

  const positions: FieldValue[] = [];
  const times = new Map<number, number>();
  const intervals = new Map<number, { cell: Pasted; value: number }>();
  for (const cell of cells) {
    const { field } = cell;
    const parsed = parseCell(cell);
    if ('unreadable' in parsed) {
      if (parsed.unreadable !== 'empty') refuse(cell, parsed.unreadable);
      continue;
    }
    const { value } = parsed;
    if (field.kind === 'interval') {
      intervals.set(field.slot, { cell, value });
      continue;
    }
    const differs = value !== valueAt(program, field);
    if (differs && isReserved(program.identity, field)) refuse(cell, 'reserved');
    else if (differs && refusalOf(field, value)) {
      refuse(cell, `${field.kind}-out-of-range`, { min: 0, max: MAX_VALUE[field.kind] });
    } else if (field.kind === 'time') times.set(field.slot, value);
    else positions.push({ field, value });
  }

  const followed = new Map([...intervals].map(([slot, { value }]) => [slot, value]));
  let retimed = retime(program, times, followed, texts);
  while ('refused' in retimed) {
    const { cause, refused } = retimed;
    const cell = intervals.get(cause)?.cell as Pasted;
    const { slot } = refused.field;
    if (refused.code === 'unreadable') refuse(cell, slot < cause ? 'before-unreadable' : 'later-unreadable');
    else refuse(cell, slot === cause ? 'time-out-of-range' : 'later-out-of-range', { min: 0, max: MAX_VALUE.time });
    followed.delete(cause);
    retimed = retime(program, times, followed, texts);
  }
  const after = withValues(program, retimed.values);
  for (const [slot, { cell, value }] of intervals) {
    if (!times.has(slot)) continue;
    const from = startOf(slot, times, followed);
    if (from && texts.unreadable?.has(fieldKey(from))) refuse(cell, 'before-unreadable');
    else if (intervalAt(after, slot) !== value) refuse(cell, 'interval-disagrees');
  }
  problems.sort((a, b) => a.row - b.row || a.column - b.column);
  return { values: [...retimed.values, ...positions], problems };
}

function isReserved({ timerClass }: Identity, { kind, slot }: GridField): boolean {
  return kind === 'time' && slot === 0 && timerClass !== 'Q';
}

/** Minutes need their colon here: with a comma between columns, `2.05,5` may be two cells. */
const TWO_MARKS = /^[^:]*[.,][^:]*[.,]/;

function parseCell({ text, field }: Pasted): Parsed {
  if (field.kind === 'position') return parseSteps(text);
  if (TWO_MARKS.test(text)) return { unreadable: 'not-a-time' };
  return field.kind === 'time' ? parseTime(text) : parseInterval(text);
}

function readingOf({ functions }: Identity, { field, text }: Pasted): PasteReading[] {
  if (field.kind === 'position') return [];
  const typed = readInterval(text, { isDt: field.slot === functions });
  return 'either' in typed ? [{ field, text, value: typed.either.at(-1) ?? typed.either[0] }] : [];
}
