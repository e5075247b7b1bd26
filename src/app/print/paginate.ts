/**
 * A section with its measured heights. Rows that continue on the next page stand below the head of the section again.
 */
export interface Measured {
  /** The height of the head; 0 without one. */
  readonly head: number;
  readonly rows: readonly number[];
  /** Whether it may begin at the foot of a page, as running text does. A table that fits on one page is not cut. */
  readonly loose?: boolean;
}

/** Empty rows at the end, as many as there is room for. */
export interface Filler {
  readonly head: number;
  readonly row: number;
  /** With room for fewer rows, they go to a page of their own. */
  readonly least: number;
  readonly most: number;
}

/** Rows of one section on one page: from `from` to before `until`. */
interface PagePart {
  readonly section: number;
  readonly from: number;
  readonly until: number;
}

export interface Pages {
  readonly pages: readonly (readonly PagePart[])[];
  /** How many empty rows stand on the last page. */
  readonly empty: number;
}

/** The fewest rows that stand together at the foot of a page, and at the head of the next. */
const TOGETHER = 2;

/**
 * Distributes rows over pages. No row is cut.
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
      // A row that is higher than a page still goes on one: there is no better place.
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

/** Measured heights do not add up exactly. */
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
