/**
 * What a pilot sets: a program, its checks, the difference of two.
 * @module program
 */

export { type CheckOptions, checkProgram, type Finding, type FindingCode, hasErrors, type Severity } from './check.js';
export { type Change, differences } from './difference.js';
export { type PartOfWrite, partWritten, type WriteExtent } from './interrupted.js';
export {
  fieldKey,
  fieldsOf,
  type ProgramField,
  sameLayout,
  seconds,
  slotKind,
  type TimerProgram,
  valueAt,
  withValue,
} from './program.js';
