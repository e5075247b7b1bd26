/**
 * The few shapes of the window: each is one of the first five. The styles have them by name, `@media (--phone)`, and
 * know no other threshold (test/tools/styles.js). In em, so that a reader with larger letters gets the shape that has
 * room for them: 16 px are one em for all others.
 */
export const SHAPES = {
  /** Held upright, with its keys in sight. The narrowest are phones however low they are. */
  phone: '((width < 35em) or ((width < 47.5em) and (height >= 30em)))',
  /** A phone on its side, or a page at 200 per cent. */
  side: '((width >= 35em) and (height < 30em))',
  tablet: '((47.5em <= width < 68.75em) and (height >= 30em))',
  laptop: '((width >= 68.75em) and (30em <= height < 45em))',
  desktop: '((width >= 68.75em) and (height >= 45em))',
  /** A page at 400 per cent: a phone in which nothing may stay at the edges. */
  zoomed: '((width < 35em) and (height < 30em))',
} as const;

/** A phone, upright or on its side: it has room for one thing at a time. */
export const NARROW = `${SHAPES.phone}, ${SHAPES.side}`;

/** Also a tablet: the strip has no room for the memories beside the other figures. */
export const TIGHT = `${NARROW}, ${SHAPES.tablet}`;

/** The head scrolls, but for the line of the strip. */
export const LOW = `${SHAPES.side}, ${SHAPES.zoomed}`;
