// The door of this room for the others: what the package gives, and what only they need.

export * from './public.js';
export { RATES, type Rates } from './settings.js';
