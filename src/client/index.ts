// The door of this room for the others: what the package gives, and what only they need.

export { tell } from './callback.js';
export * from './public.js';
export { asyncDisposable } from './timer-client.js';
