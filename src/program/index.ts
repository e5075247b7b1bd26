// The door of this room for the others: what the package gives, and what only they need.

export { MAX_VALUE, type ManualRange, manualRange } from './check.js';
export { changeRequests } from './difference.js';
export { LIMITS, requireFlight, requireLibrary, requireModel, requireSetting, requireVersion } from './library.js';
export { FILE_FORMAT, FILE_VERSION, MAX_FILE } from './library-file.js';
export { requireShape, sameKind } from './program.js';
export * from './public.js';
export * from './public-library.js';
