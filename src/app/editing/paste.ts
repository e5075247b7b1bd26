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
import {
  type Parsed,
  parseInterval,
  parseSteps,
  parseTime,
  plainDigits,
  readInterval,
  type UnreadableReason,
} from './units.js';

/**
 * What may be wrong with a pasted cell.
 * - `not-a-time`, `too-fine`, `not-a-whole-number`: it is not a value.
 * - `time-out-of-range`, `position-out-of-range` (min, max): the wire cannot carry it.
 * - `later-out-of-range` (min, max): its interval would move a later function to a time that the wire cannot carry.
 * - `before-unreadable`: its interval counts from a time that is not pasted, and whose text is not a value.
 * - `later-unreadable`: its interval would move a later function whose text is not a value.
 * - `interval-disagrees`: the row also has a time, and this interval does not follow from the times.
 * - `reserved`: slot 0 of a class other than Q can be edited only on its own.
 * - `too-large` (cells, characters): the text was not read from this row on.
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
  /** Its place in the pasted text, counted from 0, headings and row names included. */
  readonly row: number;
  readonly column: number;
  /** Its text, shortened if it is long. */
  readonly text: string;
  /** The field for which it was meant. For a cell that fills several fields: the first that refused it. */
  readonly field: GridField | null;
}

/** A pasted text that would be ambiguous where a pilot types it. In a table it is read as seconds. */
interface PasteReading {
  readonly field: GridField;
  readonly text: string;
  /** Hundredths of a second. */
  readonly value: number;
}

/**
 * What a text would do to a program.
 * With any problem nothing is done, unless the pilot wants the rest: see {@link pasted}.
 */
export interface PastePreview {
  /** The values that would change. */
  readonly changes: readonly Change[];
  /** The values that would be set, whether they change or not. */
  readonly values: readonly FieldValue[];
  /** In the order of the rows. */
  readonly problems: readonly PasteProblem[];
  /** How texts were read that would be ambiguous where a pilot types them. In the order of the rows. */
  readonly readings: readonly PasteReading[];
  /** How many filled cells have no place: past the edge of the grid, or under an unknown heading. */
  readonly ignored: number;
  /** Whether the first row was taken for headings. */
  readonly headings: boolean;
  /** Whether the first column was taken for names of rows. */
  readonly names: boolean;
}

export interface PasteOptions extends TextOption {
  /**
   * The names of the grid's columns, time first. A table with such headings that is pasted at the time column goes
   * where they say.
   */
  readonly headings?: readonly string[];
}

/** A filled cell, and where it goes. */
interface Pasted {
  readonly row: number;
  readonly column: number;
  readonly text: string;
  readonly field: GridField;
}

const LONGEST_TEXT = 60;

/**
 * What pasting a text at a range would do. The text begins at the first cell of the range and may go beyond the range;
 * a single cell fills the whole range. Empty cells change nothing. A table pasted at the time column has no intervals,
 * unless it is as wide as the grid. In a row with both, the time counts and the interval must agree with it. Intervals
 * without times are set from top to bottom; functions without a cell keep their distance to the one above.
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
 * The edit that a paste makes.
 * @param takeRest the pilot has seen the problems, and wants everything that can be read.
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
  // A row of units below them is a part of them.
  const units = headings && rows.length > 2 && areUnits(rows[1] ?? []) ? (rows[1] ?? []) : null;
  const heads = units ? 2 : headings ? 1 : 0;
  const body = rows.slice(heads);
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
      if (!field) ignored++;
      else {
        const inMinutes = field.kind !== 'position' && IN_MINUTES.test(units?.[column] ?? '');
        cells.push({ row: heads + at, column, text: inMinutes ? `${text} min` : text, field });
      }
    }
  }
  return { cells, ignored, headings, names };
}

/** The length of a row without the empty cells at its end. */
function lengthOf(texts: readonly string[]): number {
  return texts.reduce((length, text, at) => (text === '' ? length : at + 1), 0);
}

/** The columns of the grid for a table of this width. */
function acrossFrom(identity: Identity, left: number, width: number): number[] {
  const right = gridColumns(identity) - 1;
  const all = width === gridColumns(identity) && left === TIME_COLUMN;
  return all
    ? Array.from({ length: width }, (_, column) => column)
    : columnsIn(identity, { top: 0, bottom: 0, left, right });
}

/** The grid columns of these headings, -1 for an unknown one; null where none is known or one comes twice. */
function columnsByName(texts: readonly string[], known: readonly string[]): number[] | null {
  const plain = (text: string): string => text.trim().toLowerCase();
  const names = known.map(plain);
  // “Time (s)” as pilots head it, “Time s” as the table of the page does.
  const bare = (text: string): string => text.replace(/(?:\ss|\s*\(s\)|\s*\[s\])$/, '');
  const columns = texts.map(plain).map((text) => {
    if (text === '') return -1;
    return names.includes(text) ? names.indexOf(text) : names.indexOf(bare(text));
  });
  const found = columns.filter((column) => column >= 0);
  return found.length > 0 && new Set(found).size === found.length ? columns : null;
}

const WORD = /^(?!(?:nan|inf|infinity|err\s?:\d+)$)\p{L}/iu;

/**
 * Whether these are headings or names: there are some, and each begins with a letter.
 * The error texts of spreadsheets do not count.
 */
function areWords(texts: readonly string[]): boolean {
  const some = texts.filter((text) => text !== '');
  return some.length > 0 && some.every((text) => WORD.test(text));
}

const UNIT = /^[([]?(?:s|sec|secs|seconds?|min|m:ss?|mm:ss|steps?|units?)\.?[)\]]?$/i;
/** Such a unit. Times below it are in minutes. */
const IN_MINUTES = /^[([]?min/i;

/** Whether these are the units of columns, and nothing else. */
function areUnits(texts: readonly string[]): boolean {
  const some = texts.filter((text) => text !== '');
  return some.length > 0 && some.every((text) => UNIT.test(text));
}

/** What the cells set, and which of them are refused. */
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

/** Here minutes need their colon: with a comma between columns, `2.05,5` may be two cells. */
const TWO_MARKS = /^[^:]*[.,][^:]*[.,]/;

function parseCell({ text, field }: Pasted): Parsed {
  if (field.kind === 'position') return parseSteps(text);
  if (TWO_MARKS.test(plainDigits(text))) return { unreadable: 'not-a-time' };
  return field.kind === 'time' ? parseTime(text) : parseInterval(text);
}

function readingOf({ functions }: Identity, { field, text }: Pasted): PasteReading[] {
  if (field.kind === 'position') return [];
  const typed = readInterval(text, { isDt: field.slot === functions });
  return 'either' in typed ? [{ field, text, value: typed.either.at(-1) ?? typed.either[0] }] : [];
}
