import { type Filler, type Measured, paginate } from './paginate.js';
import type { Leaf } from './paper.js';
import { type Sheet, servoGroups } from './sheet.js';

/** The parts of a sheet that the pilot can choose besides the table. */
export const SHEET_PARTS = ['timeline', 'notes', 'lines', 'code'] as const;
export type SheetPart = (typeof SHEET_PARTS)[number];

/** A part of a sheet that is laid out as one block. */
export type Section =
  | { readonly kind: 'head' }
  | { readonly kind: 'table' | 'timeline'; readonly group: readonly number[] }
  | { readonly kind: 'code'; readonly link: string }
  | { readonly kind: 'warnings'; readonly lines: readonly string[] }
  | { readonly kind: 'notes'; readonly lines: readonly string[] };

/** The sections of a sheet, from top to bottom. */
export function sectionsOf(sheet: Sheet, { servos }: Leaf, parts: ReadonlySet<SheetPart>): readonly Section[] {
  const groups = servoGroups(sheet.program.positions.length, servos);
  const hasNotes = parts.has('notes') && sheet.note.some((line) => line !== '');
  return [
    { kind: 'head' },
    ...(sheet.warnings.length > 0 ? [{ kind: 'warnings' as const, lines: sheet.warnings }] : []),
    ...groups.flatMap((group): Section[] => [
      { kind: 'table', group },
      ...(parts.has('timeline') && group.length > 0 ? [{ kind: 'timeline' as const, group }] : []),
    ]),
    ...(hasNotes ? [{ kind: 'notes' as const, lines: sheet.note }] : []),
    ...(parts.has('code') && sheet.link !== null ? [{ kind: 'code' as const, link: sheet.link }] : []),
  ];
}

/** The rows of a section that stand on one page. */
export interface Piece {
  readonly section: Section;
  readonly from: number;
  readonly until: number;
}

/** One page of a sheet. */
export interface SetLeaf {
  readonly sheet: Sheet;
  readonly leaf: Leaf;
  /** The page number, from 1. */
  readonly page: number;
  readonly pages: number;
  readonly pieces: readonly Piece[];
  /** How many empty rows stand at its foot. */
  readonly empty: number;
}

/** Fewer lines to write on are not worth it; nobody flies more often in a day. */
const LINES = { least: 3, most: 12 };

export interface Copy {
  readonly sheet: Sheet;
  readonly leaf: Leaf;
  readonly sections: readonly Section[];
  /** Whether the sheet ends with lines to write on. */
  readonly hasLines: boolean;
}

/**
 * Lays a sheet out on pages, from its drawing in one piece. Without a layout (as in a test) it is one page.
 * @param galley the drawing: an element for each section, then one with one empty row, and the size of a page.
 */
export function setSheet(galley: Element, { sheet, leaf, sections, hasLines }: Copy): readonly SetLeaf[] {
  const room = heightOf(galley.querySelector('.leaf-room')) || Number.MAX_VALUE;
  const drawn = [...(galley.querySelector('.leaf-body')?.children ?? [])];
  const set = sections.map((section, at) => broken(section, drawn[at]));
  const { pages, empty } = paginate(
    set.map(({ measured }) => measured),
    room,
    hasLines ? fillerOf(drawn[sections.length]) : null,
  );
  return pages.map((parts, page) => ({
    sheet,
    leaf,
    page: page + 1,
    pages: pages.length,
    pieces: parts.flatMap(({ section, from, until }) => {
      const of = set[section];
      return of ? [{ section: of.section, from, until }] : [];
    }),
    empty: page === pages.length - 1 ? empty : 0,
  }));
}

/** The rows of a section that may continue on the next page. */
const ROWS = 'tbody > tr, .leaf-lines > p';

/** A section with the heights of its rows. Notes are split into the lines in which they will be printed. */
function broken(section: Section, drawn: Element | undefined): { section: Section; measured: Measured } {
  const whole = heightOf(drawn);
  const rows = drawn ? [...drawn.querySelectorAll(ROWS)] : [];
  if (section.kind !== 'table' && section.kind !== 'notes' && section.kind !== 'warnings') {
    return { section, measured: { head: 0, rows: [whole] } };
  }
  if (section.kind !== 'notes') {
    const heights = rows.map(heightOf);
    return { section, measured: { head: whole - sum(heights), rows: heights } };
  }
  const lines = rows.map((row) => ({ texts: linesIn(row), height: heightOf(row) }));
  const heights = lines.flatMap(({ texts, height }) => texts.map(() => height / texts.length));
  return {
    section: { kind: 'notes', lines: lines.flatMap(({ texts }) => texts) },
    measured: { head: whole - sum(heights), rows: heights, loose: true },
  };
}

function fillerOf(drawn: Element | undefined): Filler {
  const row = heightOf(drawn?.querySelector('tbody > tr'));
  return { head: heightOf(drawn) - row, row, ...LINES };
}

/** The lines into which a browser has broken a paragraph. */
function linesIn(paragraph: Element): string[] {
  const node = paragraph.firstChild;
  const text = node?.textContent ?? '';
  if (!node || text === '') return [''];
  const range = document.createRange();
  const place = (at: number): DOMRect => {
    range.setStart(node, at);
    range.setEnd(node, at + 1);
    return range.getBoundingClientRect();
  };
  const lines: string[] = [];
  for (let start = 0; start < text.length; ) {
    const { top, bottom } = place(start);
    const middle = (top + bottom) / 2;
    // The first character of the next line, found by halving: later characters never stand higher.
    let next = text.length;
    for (let last = start; next - last > 1; ) {
      const at = Math.floor((last + next) / 2);
      if (place(at).top > middle) next = at;
      else last = at;
    }
    lines.push(text.slice(start, next).trimEnd());
    start = next;
  }
  return lines;
}

function heightOf(element: Element | null | undefined): number {
  return element?.getBoundingClientRect().height ?? 0;
}

function sum(numbers: readonly number[]): number {
  return numbers.reduce((total, number) => total + number, 0);
}
