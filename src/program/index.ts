/**
 * What a pilot sets: a program, its checks, the difference of two; and what a pilot keeps: models, settings, flights.
 * @module
 */

export {
  type CheckOptions,
  checkProgram,
  type Finding,
  type FindingCode,
  hasErrors,
  type ManualRange,
  manualRange,
  type Severity,
} from './check.js';
export { type Change, changeRequests, differences } from './difference.js';
export { type PartOfWrite, partWritten, type WriteExtent } from './interrupted.js';
export {
  DUTIES,
  type Duty,
  type Flight,
  LIMITS,
  type Library,
  type Model,
  requireFlight,
  requireLibrary,
  requireModel,
  requireProgram,
  requireSetting,
  type ServoUse,
  type Setting,
  type SettingSource,
  SOURCES,
} from './library.js';
export {
  type EntryFacts,
  type FactsOf,
  FILE_FORMAT,
  FILE_VERSION,
  formatLibraryFile,
  type LibraryFile,
  MAX_FILE,
  parseLibraryFile,
  type VerifiedMemory,
} from './library-file.js';
export { decodeLink, encodeLink, LINK_MARK, type SharedSetting } from './link-code.js';
export {
  fieldKey,
  fieldsOf,
  type ProgramField,
  requireShape,
  sameKind,
  sameLayout,
  seconds,
  slotKind,
  type TimerProgram,
  valueAt,
  withValue,
} from './program.js';
