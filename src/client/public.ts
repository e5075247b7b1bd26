/**
 * One timer over one pair of byte streams: ask, wait, repeat, read all, write and verify.
 * @module client
 */

export type { DespiteOptions } from './despite.js';
export { TimerError, type TimerErrorCode, type TimerErrorDetails } from './errors.js';
export type { LineEntry, LineErrorKind } from './log.js';
export type { MemoriesRead, MemoriesReport, MemoryReport } from './memories.js';
export type {
  IdentifyOptions,
  JobOptions,
  MemoriesHooks,
  MoveOptions,
  ReadMemoriesOptions,
  ReadOptions,
  TimerClientOptions,
  WriteMemoriesOptions,
  WriteOptions,
} from './options.js';
export type { BytePort, ByteReader, ByteSink, ByteSource, ByteWriter } from './port.js';
export type { Progress } from './progress.js';
export type { AssumedQuirks, QuirkCode, QuirkParams } from './quirks.js';
export type { ProgramRead } from './read-program.js';
export { TimerClient } from './timer-client.js';
export type { ValueReport, WriteReport } from './write-report.js';
