/** Something to be printed, as high as it was measured: rows that go on on the next page, below their head again. */
export interface Measured {
  /** 0 where there is none. */
  readonly head: number;
  readonly rows: readonly number[];
  /** It may begin at the foot of a page, as running text does; a table that fits on one page is not cut. */
  readonly loose?: boolean;
}

/** Empty rows at the end, as many as there is room for. */
export interface Filler {
  readonly head: number;
  readonly row: number;
  /** With fewer rows than this it goes to a page of its own. */
  readonly least: number;
  readonly most: number;
}

/** Rows of one section on one page: `from` up to, and without, `until`. */
export interface PagePart {
  readonly section: number;
  readonly from: number;
  readonly until: number;
}

export interface Pages {
  readonly pages: readonly (readonly PagePart[])[];
  /** The empty rows on the last page. */
  readonly empty: number;
}

/** No row stands alone at the foot of a page, or at the head of the next. */
const TOGETHER = 2;

/**
 * Deals rows out to pages: none is cut.
 * @param room the height of a page, in the unit of all heights.
 */
export function paginate(sections: readonly Measured[], room: number, filler: Filler | null): Pages {
  const pages: PagePart[][] = [[]];
  let used = 0;
  const turn = (): void => {
    pages.push([]);
    used = 0;
  };
  sections.forEach((section, at) => {
    const { head, rows, loose = false } = section;
    for (let from = 0; from < rows.length; ) {
      const page = pages.at(-1) as PagePart[];
      const left = rows.length - from;
      const fitting = countFitting(rows, from, room - used - head);
      const fitsAlone = countFitting(rows, from, room - head) === left;
      const taken = fitting === left ? left : Math.min(fitting, left - TOGETHER);
      if (fitting < left && page.length > 0 && (taken < TOGETHER || (fitsAlone && !loose))) {
        turn();
        continue;
      }
      // What is higher than a page stands on one all the same: there is no better place.
      const count = Math.max(1, taken);
      page.push({ section: at, from, until: from + count });
      used += head + sum(rows.slice(from, from + count));
      from += count;
      if (from < rows.length) turn();
    }
  });
  if (!filler) return { pages, empty: 0 };
  const emptyIn = (space: number): number => Math.min(filler.most, Math.floor((space - filler.head) / filler.row || 0));
  const here = filler.row === 0 ? filler.most : emptyIn(room - used);
  if (here >= filler.least) return { pages, empty: here };
  turn();
  return { pages, empty: Math.max(filler.least, emptyIn(room)) };
}

/** A little more than nothing: heights that were measured do not add up exactly. */
const SLACK = 0.5;

function countFitting(rows: readonly number[], from: number, space: number): number {
  let rest = space + SLACK;
  let at = from;
  while (at < rows.length && (rows[at] as number) <= rest) {
    rest -= rows[at] as number;
    at++;
  }
  return at - from;
}

function sum(numbers: readonly number[]): number {
  return numbers.reduce((total, number) => total + number, 0);
}
