/** One page for the reader: a sheet of paper, or half of one. In millimetres. */
export interface Leaf {
  /** Selects the styles. */
  readonly name: 'a5' | 'a4' | 'letter' | 'half-letter';
  readonly width: number;
  /** How many servos fit beside each other in the table. */
  readonly servos: number;
  /** The height of a lane of the timeline: `most` for a single lane, `least` among many. */
  readonly lane: { readonly most: number; readonly least: number };
}

/** The margin around the print, in millimetres: no printer reaches the edge. The same as in leaf.css. */
export const MARGIN = 10;

const SMALL = { servos: 8, lane: { most: 13, least: 7 } } as const;
const LARGE = { servos: 10, lane: { most: 20, least: 8 } } as const;
const LEAVES = {
  a5: { name: 'a5', width: 148, ...SMALL },
  a4: { name: 'a4', width: 210, ...LARGE },
  letter: { name: 'letter', width: 215.9, ...LARGE },
  'half-letter': { name: 'half-letter', width: 139.7, ...SMALL },
} as const satisfies Record<string, Leaf>;

/** The papers in the printer. With `-two`, two pages lie side by side on one sheet. */
export const PAPERS = ['a5', 'a4', 'letter', 'a4-two', 'letter-two'] as const;
export type Paper = (typeof PAPERS)[number];

const LEAF_OF: Readonly<Record<Paper, Leaf>> = {
  a5: LEAVES.a5,
  a4: LEAVES.a4,
  letter: LEAVES.letter,
  'a4-two': LEAVES.a5,
  'letter-two': LEAVES['half-letter'],
};

/** The page that a paper gives. */
export function leafOf(paper: Paper): Leaf {
  return LEAF_OF[paper];
}

/** How many pages lie on one sheet of paper. */
export function leavesOn(paper: Paper): 1 | 2 {
  return paper.endsWith('-two') ? 2 : 1;
}

/** Converts a length on paper to CSS pixels: 96 to the inch. */
export function pixelsOf(millimetres: number): number {
  return (millimetres * 96) / 25.4;
}
