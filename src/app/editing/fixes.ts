import { type Finding, MAX_VALUE, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { type FieldValue, stepSize } from './edit.js';

/** The findings about times that do not rise. */
const OF_ORDER: ReadonlySet<Finding['code']> = new Set(['time-falls', 'time-repeats', 'position-never-reached']);

/**
 * The value that corrects a finding, where a pilot would choose it without thinking: the nearest value that the wire
 * carries, the step of the manual, the limit that was passed, or the next step after the function before. When DT comes
 * too early, another time may just as well be wrong, so nothing that makes the flight longer is offered. Nor is a time
 * that would not come before the next function: then the time before it is the one to look at.
 * @returns null when the pilot has to decide.
 */
export function fixFor({ code, field, params }: Finding, program: TimerProgram): FieldValue | null {
  const value = field && valueAt(program, field);
  if (!field || value === null) return null;
  const better = betterValue(code, value, params, stepSize(program.identity, field));
  const fits = better !== null && better !== value && better >= 0 && better <= MAX_VALUE[field.kind];
  if (!fits || (OF_ORDER.has(code) && !isBeforeNext(program, field, better))) return null;
  return { field, value: better };
}

function betterValue(
  code: Finding['code'],
  value: number,
  { previous, limit, min, max, step }: Finding['params'],
  usualStep: number,
): number | null {
  switch (code) {
    case 'time-not-whole':
    case 'position-not-whole':
    case 'throttle-not-whole':
      return Math.round(value);
    case 'time-out-of-range':
    case 'position-out-of-range':
    case 'throttle-out-of-range':
    case 'time-outside-manual':
      return Math.min(Math.max(value, Number(min)), Number(max));
    case 'time-falls':
    case 'time-repeats':
    case 'position-never-reached':
      return (Math.floor(Number(previous) / usualStep) + 1) * usualStep;
    case 'time-too-fine':
      return Math.round(value / Number(step)) * Number(step);
    case 'motor-run-long':
      return Number(limit);
    default:
      return null;
  }
}

/** Whether a function at this time still comes before the next one. DT has no next one. */
function isBeforeNext({ times }: TimerProgram, field: ProgramField, time: number): boolean {
  const next = field.kind === 'time' ? times[field.slot + 1] : undefined;
  return next !== undefined && time < next;
}
