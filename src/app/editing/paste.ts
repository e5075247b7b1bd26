import {
  type Change,
  differences,
  type FindingCode,
  fieldKey,
  MAX_VALUE,
  type TimerProgram,
  valueAt,
} from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { MAX_CELLS, MAX_CHARACTERS, readTable, type TextCell } from './clipboard-table.js';
import { type Edit, type FieldValue, refusalOf, setValues, type TextOption, withValues } from './edit.js';
import { retime, startOf } from './edits.js';
import { fieldsIn, type GridField, type GridRange, intervalAt } from './grid.js';
import type { StepName } from './history.js';
import { type MisplacedCode, type Pasted, place } from './paste-place.js';
import type { PasteAnswers, PasteQuestion } from './paste-questions.js';
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
 * - `unreadable`: its interval counts from a time that is not pasted, or would move a later function, and the text of
 *   that is not a value.
 * - `interval-disagrees`: the row also has a time, and this interval does not follow from the times.
 * - `no-place`, `twice`, `start`: see {@link MisplacedCode}.
 * - `too-large` (cells, characters): the text was not read from this row on.
 */
export type PasteProblemCode =
  | Exclude<UnreadableReason, 'empty' | 'ambiguous'>
  | Extract<FindingCode, 'time-out-of-range' | 'position-out-of-range'>
  | 'later-out-of-range'
  | 'unreadable'
  | 'interval-disagrees'
  | MisplacedCode
  | 'too-large';

export interface PasteProblem extends TextCell {
  readonly code: PasteProblemCode;
  readonly params: Readonly<Record<string, number>>;
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
 * What a text would do to a program: see {@link pasted}.
 */
export interface PastePreview {
  /** The values that would change. */
  readonly changes: readonly Change[];
  /** The values that would be set, whether they change or not. */
  readonly values: readonly FieldValue[];
  /** In the order of the rows; that the text was not read to its end comes first. */
  readonly problems: readonly PasteProblem[];
  /** How texts were read that would be ambiguous where a pilot types them. In the order of the rows. */
  readonly readings: readonly PasteReading[];
  /** The cells that have a place, in the order of the text. */
  readonly cells: readonly Pasted[];
  /** The names that are not known. While one is open, nothing is pasted. */
  readonly questions: readonly PasteQuestion[];
}

export interface PasteOptions extends TextOption {
  /** What the pilot has said about names that are not known. Default: nothing. */
  readonly answers?: PasteAnswers;
}

const LONGEST_TEXT = 60;

/**
 * What pasting a text at a range would do. Rows and columns with names go where they say: see {@link place}. Any other
 * text begins at the first cell of the range and may go beyond the range; a single cell fills the whole range. Empty
 * cells change nothing. A table pasted at the time column has no intervals, unless it is as wide as the grid. In a row
 * with both, the time counts and the interval must agree with it. Intervals without times are set from top to bottom;
 * functions without a cell keep their distance to the one above.
 */
export function previewPaste(
  program: TimerProgram,
  range: GridRange,
  text: string,
  { answers = new Map(), unreadable }: PasteOptions = {},
): PastePreview {
  const { identity } = program;
  const { rows, cut } = readTable(text);
  const isSingle = !cut && rows.length === 1 && rows[0]?.length === 1;
  const { cells, misplaced, questions } = isSingle
    ? fill(identity, range, rows[0]?.[0] ?? '')
    : place(identity, range, rows, answers);
  const { values, problems } = resolve(program, cells, { unreadable });
  for (const each of misplaced) problems.push({ ...each, params: {}, text: each.text.slice(0, LONGEST_TEXT) });
  problems.sort((a, b) => a.row - b.row || a.column - b.column);
  if (cut) {
    const params = { cells: MAX_CELLS, characters: MAX_CHARACTERS };
    problems.unshift({ code: 'too-large', params, row: rows.length, column: 0, text: '', field: null });
  }
  const readings = cells.flatMap((cell) => readingOf(identity, cell));
  const changes = differences(program, withValues(program, values));
  return { changes, values, problems, readings, cells, questions };
}

/** The edit that a paste makes: everything that can be read. The pilot has seen the problems. */
export function pasted({ changes, values, questions }: PastePreview): Edit {
  const name: StepName = { code: 'paste', params: { count: changes.length } };
  return setValues(name, questions.some(({ answer }) => answer === null) ? [] : values);
}

function fill(identity: Identity, range: GridRange, text: string): ReturnType<typeof place> {
  const fields = text === '' ? [] : fieldsIn(identity, range);
  const cell = { row: 0, column: 0, text };
  const isOut = text !== '' && fields.length === 0;
  return {
    cells: fields.map((field) => ({ ...cell, field })),
    misplaced: isOut ? [{ code: 'no-place', ...cell, field: null }] : [],
    questions: [],
  };
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
    if (differs && isReserved(program.identity, field)) refuse(cell, 'start');
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
    if (refused.code === 'unreadable') refuse(cell, 'unreadable');
    else refuse(cell, slot === cause ? 'time-out-of-range' : 'later-out-of-range', { min: 0, max: MAX_VALUE.time });
    followed.delete(cause);
    retimed = retime(program, times, followed, texts);
  }
  const after = withValues(program, retimed.values);
  for (const [slot, { cell, value }] of intervals) {
    if (!times.has(slot)) continue;
    const from = startOf(slot, times, followed);
    if (from && texts.unreadable?.has(fieldKey(from))) refuse(cell, 'unreadable');
    else if (intervalAt(after, slot) !== value) refuse(cell, 'interval-disagrees');
  }
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
