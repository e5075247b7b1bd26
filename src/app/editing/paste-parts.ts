import type { Identity } from '../../protocol/index.js';
import { MAX_CELLS } from './clipboard-table.js';
import { areWords, isColumnName, isUnit, rowNamed } from './paste-names.js';

export type Rows = readonly (readonly string[])[];

/** A part of a table: rows below one row of headings, or without one. */
export interface Part {
  readonly heading: number | null;
  readonly units: number | null;
  /** The first row of values, and the row after the last. */
  readonly from: number;
  readonly to: number;
}

/** The length of a row without the empty cells at its end. */
export function lengthOf(texts: readonly string[]): number {
  return texts.reduce((length, text, at) => (text === '' ? length : at + 1), 0);
}

const filled = (texts: readonly string[]): string[] => texts.filter((text) => text !== '');

function isNamedRow(identity: Identity, text: string): boolean {
  return rowNamed(identity, text, false) !== 'unknown' && !isColumnName(text);
}

/** Headings that are known, over more than one column. */
function isHeading(texts: readonly string[]): boolean {
  return filled(texts).length > 1 && areWords(texts) && texts.some(isColumnName);
}

/** Lines of text above the first headings, as on a printed sheet, are no part of the table. */
export function partsOf(identity: Identity, rows: Rows): Part[] {
  const first = Math.max(0, rows.findIndex(isHeading));
  // Words alone begin another table, such as that of the flights on a printed sheet.
  const isOther = (texts: readonly string[]): boolean =>
    filled(texts).length > 1 &&
    areWords(texts) &&
    !filled(texts).every(isUnit) &&
    !isNamedRow(identity, filled(texts)[0] ?? '');
  const found = rows.flatMap((texts, row) => (isHeading(texts) || (row > first && isOther(texts)) ? [row] : []));
  const heads = rows.slice(0, first).every((texts) => filled(texts).length < 2) ? found : [];
  const [top = []] = rows;
  // Headings in words that are not known are headings, too.
  const isAtTop = rows.length > 1 && areWords(top) && !filled(top).every((text) => isNamedRow(identity, text));
  if (heads.length === 0 && isAtTop) heads.push(0);
  if (rows.length === 1 || heads.length === 0) return [{ heading: null, units: null, from: 0, to: rows.length }];
  return heads.map((heading, at): Part => {
    const to = heads[at + 1] ?? rows.length;
    const below = rows[heading + 1] ?? [];
    const units = to > heading + 2 && filled(below).length > 0 && filled(below).every(isUnit) ? heading + 1 : null;
    return { heading, units, from: (units ?? heading) + 1, to };
  });
}

/** Whether the columns of values are the slots: its first column has the headings, or its first row the slots. */
export function isSideways(identity: Identity, rows: Rows): boolean {
  const [top = []] = rows;
  const width = Math.max(0, ...rows.map(lengthOf));
  if (width < 2 || width * rows.length > MAX_CELLS || top.slice(1).some(isColumnName)) return false;
  const below = rows.slice(1).filter((texts) => filled(texts).length > 1 && isColumnName(texts[0] ?? '')).length;
  const slots = top.slice(1).filter((text) => isNamedRow(identity, text)).length;
  return below > 0 || slots > 1 || (rows.length === 1 && isColumnName(top[0] ?? '') && !areWords(top));
}

export function turned(rows: Rows): Rows {
  const width = Math.max(0, ...rows.map(lengthOf));
  return Array.from({ length: width }, (_, column) => rows.map((texts) => texts[column] ?? ''));
}
