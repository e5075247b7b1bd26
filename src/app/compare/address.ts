/** The address of the comparison, after `#library/`. */
export const COMPARE = 'compare';
