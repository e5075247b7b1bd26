import { type Filler, type Measured, paginate } from './paginate.js';
import type { Leaf } from './paper.js';
import { type Sheet, servoGroups } from './sheet.js';

/** What the pilot wants on the sheet beside the table. */
export const SHEET_PARTS = ['timeline', 'notes', 'lines', 'code'] as const;
export type SheetPart = (typeof SHEET_PARTS)[number];

/** A part of a sheet that is set by itself. */
export type Section =
  | { readonly kind: 'head' }
  | { readonly kind: 'table' | 'timeline'; readonly group: readonly number[] }
  | { readonly kind: 'code'; readonly link: string }
  | { readonly kind: 'warnings'; readonly lines: readonly string[] }
  | { readonly kind: 'notes'; readonly lines: readonly string[] };

/** What a sheet consists of, from above. */
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

/** A section on one page, with the rows that stand there. */
export interface Piece {
  readonly section: Section;
  readonly from: number;
  readonly until: number;
}

/** One page of a sheet. */
export interface SetLeaf {
  readonly sheet: Sheet;
  readonly leaf: Leaf;
  /** From 1. */
  readonly page: number;
  readonly pages: number;
  readonly pieces: readonly Piece[];
  /** So many empty rows are at its foot. */
  readonly empty: number;
}

/** Fewer lines to write on are not worth it; more nobody flies in a day. */
const LINES = { least: 3, most: 12 };

export interface Copy {
  readonly sheet: Sheet;
  readonly leaf: Leaf;
  readonly sections: readonly Section[];
  /** Whether it ends with room to write. */
  readonly hasLines: boolean;
}

/**
 * Sets a sheet on pages, as it was drawn in one piece. Where nothing is laid out it is one page.
 * @param galley what was drawn: an element for each section, then one with one empty row; and the room of a page.
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

/** The rows of what can be cut. */
const ROWS = 'tbody > tr, .leaf-lines > p';

/** A section with the heights of its rows; notes come in the lines in which they are to be printed. */
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

/** The lines in which a browser has set a paragraph. */
export function linesIn(paragraph: Element): string[] {
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
    // The first character of the next line, found by halving: what follows is never above.
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
