import type { Identity } from '../../protocol/index.js';
import type { TextCell } from './clipboard-table.js';
import {
  cellKey,
  columnsIn,
  type GridField,
  type GridRange,
  gridColumns,
  gridField,
  INTERVAL_COLUMN,
  TIME_COLUMN,
} from './grid.js';
import {
  areWords,
  type ColumnPlace,
  columnNamed,
  isColumnName,
  isInMinutes,
  isMinutes,
  type RowPlace,
  rowNamed,
} from './paste-names.js';
import { isSideways, lengthOf, type Part, partsOf, type Rows, turned } from './paste-parts.js';
import { type PasteAnswers, type PasteQuestion, PasteQuestions } from './paste-questions.js';
import { parseTime } from './units.js';

/** A filled cell, and where it goes. */
export interface Pasted extends TextCell {
  readonly field: GridField;
}

/**
 * What cannot be placed.
 * - `no-place`: the program has no such row, column or cell.
 * - `twice`: another cell of the text goes to the same place and says something else.
 * - `start`: a time for the start, which is where times begin. On a class other than Q it is reserved.
 */
export type MisplacedCode = 'no-place' | 'twice' | 'start';

export interface Misplaced extends TextCell {
  readonly code: MisplacedCode;
  readonly field: GridField | null;
}

export interface Placed {
  readonly cells: readonly Pasted[];
  readonly misplaced: readonly Misplaced[];
  /** The names that are not known, and what the pilot has said about them. Cells below an open one are in no list. */
  readonly questions: readonly PasteQuestion[];
}

/**
 * Where the cells of a table go. Names win: a row goes to the slot that it names, a column to the time, interval or
 * servo, wherever the range is. Without names the table begins at the first cell of the range. A table with the slots
 * side by side is turned, and one that comes in parts, as paper has it for many servos, is read part by part.
 */
export function place(identity: Identity, range: GridRange, rows: Rows, answers: PasteAnswers): Placed {
  const placing = new Placing(identity, range, rows, answers);
  for (const part of partsOf(identity, placing.rows)) placing.add(part);
  return placing.result();
}

class Placing {
  readonly #cells: Pasted[] = [];
  readonly #misplaced: Misplaced[] = [];
  readonly identity: Identity;
  readonly range: GridRange;
  readonly rows: Rows;
  readonly questions: PasteQuestions;
  readonly isTurned: boolean;

  constructor(identity: Identity, range: GridRange, rows: Rows, answers: PasteAnswers) {
    this.identity = identity;
    this.range = range;
    this.isTurned = isSideways(identity, rows);
    this.rows = this.isTurned ? turned(rows) : rows;
    this.questions = new PasteQuestions(identity.functions, answers);
  }

  add(part: Part): void {
    const { from, to } = part;
    const width = Math.max(0, ...this.rows.slice(part.heading ?? from, to).map(lengthOf));
    const names = this.#nameColumn(part, width);
    const columns = this.#columns(part, width, names);
    for (let row = from; row < to; row++) {
      const isEmpty = (this.rows[row] ?? []).every((text, column) => text === '' || column === names);
      if (isEmpty) continue;
      const place = names === null ? { slot: this.range.top + row - from } : this.#row(row, names);
      if (typeof place === 'object' && names !== null && place.slot > this.identity.functions) {
        this.#refuse('no-place', row, names);
      } else if (place !== 'unknown' && place !== 'none') this.#addRow(part, row, names, place, columns);
    }
  }

  result(): Placed {
    const byPlace = new Map<string, Pasted[]>();
    for (const cell of this.#cells) {
      const key = cellKey(cell.field);
      byPlace.set(key, [...(byPlace.get(key) ?? []), cell]);
    }
    const cells: Pasted[] = [];
    for (const [first, ...others] of byPlace.values() as Iterable<[Pasted, ...Pasted[]]>) {
      if (others.every(({ text }) => text === first.text)) cells.push(first);
      else for (const cell of [first, ...others]) this.#misplaced.push({ code: 'twice', ...cell });
    }
    return {
      cells,
      misplaced: this.#misplaced,
      questions: this.questions.list,
    };
  }

  /** The column with the names of the rows. */
  #nameColumn({ heading, from, to }: Part, width: number): number | null {
    const headings = heading === null ? [] : (this.rows[heading] ?? []);
    const textsIn = (column: number): string[] => this.rows.slice(from, to).map((texts) => texts[column] ?? '');
    const said = headings.findIndex((_, column) => this.#isNames(this.#asked(heading ?? 0, column)));
    if (said >= 0) return textsIn(said).some((text) => text !== '') ? said : null;
    const [first = ''] = headings;
    if (width < 2 || isColumnName(first)) return null;
    const texts = textsIn(0);
    if (areWords(texts)) return 0;
    const some = texts.filter((text) => text !== '');
    const isNumbered =
      some.some((text) => rowNamed(this.identity, text, false) !== 'unknown') ||
      (heading !== null && first === '' && headings.every((text) => text === '' || isColumnName(text)));
    return some.length > 0 && isNumbered && some.every((text) => rowNamed(this.identity, text, true) !== 'unknown')
      ? 0
      : null;
  }

  #isNames(asked: TextCell): boolean {
    return columnNamed(asked.text) === 'names' || this.questions.answered('column', asked) === 'names';
  }

  /** Where the columns go, by their headings or by the range. */
  #columns({ heading, units, from, to }: Part, width: number, names: number | null): ColumnPlace[] {
    if (heading === null) {
      const first = names === 0 ? 1 : 0;
      const across = acrossFrom(this.identity, this.range.left, width - first);
      return Array.from({ length: width }, (_, column) => ({ column: across[column - first] ?? -1, inMinutes: false }));
    }
    return Array.from({ length: width }, (_, column): ColumnPlace => {
      const asked = this.#asked(heading, column);
      const isUsed = this.rows.slice(from, to).some((texts) => (texts[column] ?? '') !== '');
      const known = columnNamed(asked.text);
      // The answer can be changed.
      if (column === names && known !== 'names' && this.#isNames(asked)) return this.questions.column(asked);
      if (column === names || !isUsed) return 'none';
      const place = typeof known === 'object' ? known : this.questions.column(asked);
      const unit = units === null ? '' : (this.rows[units]?.[column] ?? '');
      return typeof place === 'object' && isMinutes(unit) ? { ...place, inMinutes: true } : place;
    });
  }

  #row(row: number, names: number): RowPlace {
    const asked = this.#asked(row, names);
    const known = rowNamed(this.identity, asked.text, true);
    return known === 'unknown' ? this.questions.row(asked) : known;
  }

  #addRow(
    part: Part,
    row: number,
    names: number | null,
    place: { slot: number } | 'motor',
    columns: ColumnPlace[],
  ): void {
    const name = names === null ? '' : (this.rows[row]?.[names] ?? '');
    for (const [at, raw] of (this.rows[row] ?? []).entries()) {
      const column = columns[at];
      if (raw === '' || at === names || typeof column !== 'object') continue;
      const isTime = column.column <= INTERVAL_COLUMN;
      const text = isTime && (column.inMinutes || isInMinutes(name)) ? `${raw} min` : raw;
      const slot = place === 'motor' ? 0 : place.slot;
      const field = gridField(this.identity, { row: slot, column: column.column });
      const isOurs = place !== 'motor' || (column.column === TIME_COLUMN && this.identity.timerClass === 'Q');
      if (part.heading !== null && column.column >= gridColumns(this.identity)) {
        this.#refuse('no-place', part.heading, at);
      } else if (place !== 'motor' && names !== null && slot === 0 && isTime) {
        this.#startTime(row, at, text, column.column);
      } else if (field && isOurs) this.#put(row, at, text, field);
      else this.#refuse('no-place', row, at);
    }
  }

  /** The start is where times begin, so its 0 says nothing. On other classes than Q its time is reserved. */
  #startTime(row: number, at: number, text: string, column: number): void {
    const parsed = parseTime(text);
    if ('value' in parsed && parsed.value === 0) return;
    const field = gridField(this.identity, { row: 0, column });
    if (field && this.identity.timerClass !== 'Q') this.#put(row, at, text, field);
    else this.#refuse('start', row, at);
  }

  #put(row: number, column: number, text: string, field: GridField): void {
    this.#cells.push({ ...this.#inText(row, column), text, field });
  }

  #refuse(code: MisplacedCode, row: number, column: number): void {
    const at = this.#inText(row, column);
    if (this.#misplaced.some((known) => known.row === at.row && known.column === at.column)) return;
    this.#misplaced.push({ code, ...at, text: this.rows[row]?.[column] ?? '', field: null });
  }

  #asked(row: number, column: number): TextCell {
    return { text: this.rows[row]?.[column] ?? '', ...this.#inText(row, column) };
  }

  #inText(row: number, column: number): { row: number; column: number } {
    return this.isTurned ? { row: column, column: row } : { row, column };
  }
}

/** The columns of the grid for a table of this width without headings. */
function acrossFrom(identity: Identity, left: number, width: number): number[] {
  const right = gridColumns(identity) - 1;
  const all = width === gridColumns(identity) && left === TIME_COLUMN;
  return all
    ? Array.from({ length: width }, (_, column) => column)
    : columnsIn(identity, { top: 0, bottom: 0, left, right });
}
