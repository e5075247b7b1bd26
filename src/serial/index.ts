// The door of this room for the others: what the package gives, and what only they need.

export { choosePort, rememberedPorts } from './choose.js';
export type { LinkEvent } from './link-table.js';
export { portKey, portKind } from './ports.js';
export * from './public.js';
export { RATES, type Rates } from './settings.js';
