// The door of this room for the others: what the package gives, and what only they need.

export { BITS_PER_BYTE, ByteLine, wireTime } from './byte-line.js';
export { realClock, soon } from './clock.js';
export * from './public.js';
