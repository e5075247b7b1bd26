/** Where two programs stand side by side, in the address after `#library/`. */
export const COMPARE = 'compare';
