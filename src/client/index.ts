export { TimerError, type TimerErrorCode, type TimerErrorDetails } from './errors.js';
export type { LineEntry } from './log.js';
export type { BytePort } from './port.js';
export type { Progress } from './progress.js';
export type { AssumedQuirks, QuirkCode, QuirkParams } from './quirks.js';
export {
  type JobOptions,
  type ReadOptions,
  TimerClient,
  type TimerClientOptions,
  type WriteOptions,
} from './timer-client.js';
export type { ValueReport, WriteReport } from './write-program.js';
