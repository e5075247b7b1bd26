// The door of this room for the others: what the package gives, and what only they need.

export { COMMAND_NAMES } from './commands.js';
export {
  checksum,
  frameSize,
  MAX_DATA,
  MAX_LENGTH,
  MIN_LENGTH,
  TERMINATOR,
  ZEROS_NEEDED,
  ZEROS_SENT,
} from './frame.js';
export { isUsualVersion, requireIdentity } from './identity.js';
export { answers, exchangeSize } from './messages.js';
export * from './public.js';
