// The door of this room for the others: what the package gives, and what only they need.

export { firstContent } from './memory.js';
export * from './public.js';
export { TimerCore } from './timer-core.js';
