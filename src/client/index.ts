export { TimerError, type TimerErrorCode, type TimerErrorDetails } from './errors.js';
export type { LineEntry, QuirkCode } from './log.js';
export type { BytePort } from './port.js';
export type { Progress } from './progress.js';
export { type JobOptions, TimerClient, type TimerClientOptions, type WriteOptions } from './timer-client.js';
export type { ValueReport, WriteReport } from './write-program.js';
