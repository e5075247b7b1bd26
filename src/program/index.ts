export {
  type CheckOptions,
  checkProgram,
  type Finding,
  type FindingCode,
  hasErrors,
  manualRange,
  type Severity,
} from './check.js';
export { type Change, changeRequests, differences } from './difference.js';
export {
  columnKind,
  fieldKey,
  fieldsOf,
  type ProgramField,
  requireShape,
  sameKind,
  sameLayout,
  type TimerProgram,
  valueAt,
  withValue,
} from './program.js';
