import { type Hundredths, type Identity, MAX_POSITION, MAX_TIME } from '../protocol/index.js';
import { fieldsOf, type ProgramField, requireShape, slotKind, type TimerProgram, valueAt } from './program.js';

/**
 * How much a finding weighs.
 * - `error`: the wire cannot carry it, so the program cannot be written.
 * - `serious`: it may cost a model, so the pilot must acknowledge it before a write.
 * - `warning`: it is unusual.
 */
export type Severity = 'error' | 'serious' | 'warning';

/**
 * What the check may find. Times in the parameters are hundredths of a second.
 *
 * - `time-not-whole`, `time-out-of-range` (min, max): the wire cannot carry this time.
 * - `position-not-whole`, `position-out-of-range` (min, max): nor this position.
 * - `throttle-not-whole`, `throttle-out-of-range` (min, max): nor this idle throttle.
 * - `position-as-read` (value): the timer holds a position past its last step; it stays so unless the pilot edits it.
 * - `time-falls` (previous): a function comes before the one it follows.
 * - `time-repeats` (previous): two functions share a time and hold the same positions.
 * - `position-never-reached` (previous): two functions share a time, so the positions of the earlier one are never
 *   reached.
 * - `motor-stop-after-dt` (dt): class Q; the model comes down with the motor running.
 * - `motor-run-long` (limit): class Q; longer than the rules allow.
 * - `time-outside-manual` (min, max): not in the range that the maker's manual gives.
 * - `time-too-fine` (step): finer than the steps that the manual gives; the timer may round it.
 * - `dt-short` (limit): a short DT, good for trimming, lost for a contest flight. Below ten seconds it is serious: it
 *   brings a climbing model down, and was often meant in seconds.
 * - `dt-moves-nothing`: every servo stands at DT where it stood before; nothing that this timer does brings the model
 *   down.
 * - `throttle-unusual` (limit): more than 100; the unit is not known.
 * - `class-unknown` (timerClass): the timer's letter is not B, Q or E, so no rule of a class was checked.
 */
export type FindingCode =
  | 'time-not-whole'
  | 'time-out-of-range'
  | 'position-not-whole'
  | 'position-out-of-range'
  | 'throttle-not-whole'
  | 'throttle-out-of-range'
  | 'position-as-read'
  | 'time-falls'
  | 'time-repeats'
  | 'position-never-reached'
  | 'motor-stop-after-dt'
  | 'motor-run-long'
  | 'time-outside-manual'
  | 'time-too-fine'
  | 'dt-short'
  | 'dt-moves-nothing'
  | 'throttle-unusual'
  | 'class-unknown';

/** One thing that the check has found. */
export interface Finding {
  /** How much it weighs. */
  readonly severity: Severity;
  /** What it is. */
  readonly code: FindingCode;
  /** The value that it is about; null when it is about the whole program. */
  readonly field: ProgramField | null;
  /** Its facts by name, as {@link FindingCode} lists them. */
  readonly params: Readonly<Record<string, number | string>>;
}

/** What the check takes into account. */
export interface CheckOptions {
  /** What the timer held. A position past the last step is no error while it equals the one that was read. */
  readonly baseline?: TimerProgram | undefined;
  /** A DT below this counts as short. Default 6000 (one minute). */
  readonly shortDt?: Hundredths | undefined;
}

/** F1Q: the motor may run for 40 s at most. */
const LONGEST_MOTOR_RUN = 4000;
const SHORT_DT = 6000;
/** A DT below this comes while the model still climbs: 180 hundredths were meant as seconds. */
const DT_IN_CLIMB = 1000;
/** The largest value of each kind that the wire carries. */
export const MAX_VALUE = { time: MAX_TIME, position: MAX_POSITION, idleThrottle: 255 };
const USUAL_THROTTLE = 100;

/**
 * Everything that a pilot should know about a program before it is written: first what the wire cannot carry, field by
 * field, then all other findings. Slot 0 has no place in the rising order: it is the motor stop on Q, and reserved on B
 * and E.
 * @throws CodecError `wrong-count` when the lists do not have the shape of the identity.
 * @example
 * ```ts
 * import { TimerClient } from 'sidus-timer/client';
 * import { checkProgram, seconds, withValue } from 'sidus-timer/program';
 * import { VirtualTimer } from 'sidus-timer/simulator';
 *
 * const timer = new TimerClient(new VirtualTimer());
 * const program = await timer.readProgram();
 * await timer.close();
 * const short = withValue(program, { kind: 'time', slot: 10 }, seconds(20)); // DT
 * console.log(checkProgram(short).some(({ code }) => code === 'dt-short')); // true
 * ```
 */
export function checkProgram(program: TimerProgram, options: CheckOptions = {}): Finding[] {
  requireShape(program);
  const errors = fieldsOf(program.identity).flatMap((field) => carried(program, field, options.baseline));
  const wrong = new Set(errors.flatMap(({ field }) => (field?.kind === 'time' ? [field.slot] : [])));
  return [
    ...errors,
    ...order(program, wrong),
    ...motor(program, wrong),
    ...manual(program, wrong),
    ...(wrong.has(program.identity.functions) ? [] : dethermaliser(program, options.shortDt ?? SHORT_DT)),
    ...dtPositions(program),
    ...throttle(program),
    ...timerClass(program.identity),
  ];
}

/** Whether a write is impossible. */
export function hasErrors(findings: readonly Finding[]): boolean {
  return findings.some(({ severity }) => severity === 'error');
}

/** Values that the wire cannot carry. */
function carried(program: TimerProgram, field: ProgramField, baseline: TimerProgram | undefined): Finding[] {
  const value = valueAt(program, field);
  if (value === null) return [];
  const kind = field.kind === 'idleThrottle' ? 'throttle' : field.kind;
  const max = MAX_VALUE[field.kind];
  if (!Number.isInteger(value)) return [{ severity: 'error', code: `${kind}-not-whole`, field, params: {} }];
  if (value >= 0 && value <= max) return [];
  if (field.kind === 'position' && baseline && valueAt(baseline, field) === value) {
    return [{ severity: 'warning', code: 'position-as-read', field, params: { value, max } }];
  }
  return [{ severity: 'error', code: `${kind}-out-of-range`, field, params: { min: 0, max } }];
}

/**
 * Functions must rise strictly. That is certain for Q;
 * for B and E the manuals differ, so the finding weighs less there.
 */
function order({ identity, times, positions }: TimerProgram, wrong: ReadonlySet<number>): Finding[] {
  const found: Finding[] = [];
  for (let at = 2; at <= identity.functions; at++) {
    if (wrong.has(at) || wrong.has(at - 1)) continue;
    const previous = times[at - 1] as number;
    const time = times[at] as number;
    const field: ProgramField = { kind: 'time', slot: at };
    if (time < previous) {
      const severity = identity.timerClass === 'B' || identity.timerClass === 'E' ? 'warning' : 'serious';
      found.push({ severity, code: 'time-falls', field, params: { previous } });
    } else if (time === previous) {
      const moves = positions.some((row) => row[at] !== row[at - 1]);
      const code = moves ? 'position-never-reached' : 'time-repeats';
      found.push({ severity: 'warning', code, field, params: { previous } });
    }
  }
  return found;
}

function motor({ identity, times }: TimerProgram, wrong: ReadonlySet<number>): Finding[] {
  if (identity.timerClass !== 'Q' || wrong.has(0)) return [];
  const field: ProgramField = { kind: 'time', slot: 0 };
  const stop = times[0] as number;
  const dt = times[identity.functions] as number;
  const found: Finding[] = [];
  if (!wrong.has(identity.functions) && stop > dt) {
    found.push({ severity: 'serious', code: 'motor-stop-after-dt', field, params: { dt } });
  }
  if (stop > LONGEST_MOTOR_RUN) {
    found.push({ severity: 'warning', code: 'motor-run-long', field, params: { limit: LONGEST_MOTOR_RUN } });
  }
  return found;
}

/** Ranges and steps from the manuals of 2010, in hundredths of a second. */
export interface ManualRange {
  /** The shortest time. */
  readonly min: number;
  /** The longest time. */
  readonly max: number;
  /** Times are multiples of it. */
  readonly step: number;
}

const TENTHS: ManualRange = { min: 10, max: 9990, step: 10 };
const HUNDREDTHS: ManualRange = { min: 1, max: 999, step: 1 };
const SECONDS: ManualRange = { min: 100, max: 72000, step: 100 };

/**
 * The range and step that the manual gives for the time of a slot. Null where it gives none: class E, an unknown class,
 * the reserved slot of B.
 */
export function manualRange(identity: Identity, at: number): ManualRange | null {
  const { timerClass } = identity;
  if (timerClass !== 'Q' && timerClass !== 'B') return null;
  const kind = slotKind(identity, at);
  if (kind === 'dt') return SECONDS;
  if (timerClass === 'Q') return TENTHS;
  if (kind === 'start') return null;
  return at <= 2 ? HUNDREDTHS : TENTHS;
}

function manual({ identity, times }: TimerProgram, wrong: ReadonlySet<number>): Finding[] {
  return times.flatMap((time, at): Finding[] => {
    const range = manualRange(identity, at);
    if (!range || wrong.has(at)) return [];
    const field: ProgramField = { kind: 'time', slot: at };
    const { min, max, step } = range;
    if (time < min || time > max) {
      return [{ severity: 'warning', code: 'time-outside-manual', field, params: { min, max } }];
    }
    if (time % step !== 0) return [{ severity: 'warning', code: 'time-too-fine', field, params: { step } }];
    return [];
  });
}

function dethermaliser({ identity, times }: TimerProgram, limit: number): Finding[] {
  const at = identity.functions;
  const time = times[at] as number;
  if (time >= Math.max(limit, DT_IN_CLIMB)) return [];
  const severity = time < DT_IN_CLIMB ? 'serious' : 'warning';
  return [{ severity, code: 'dt-short', field: { kind: 'time', slot: at }, params: { limit } }];
}

/** Only a warning: something else may bring the model down, such as a radio DT. */
function dtPositions({ identity, positions }: TimerProgram): Finding[] {
  const at = identity.functions;
  if (positions.some((row) => row[at] !== row[at - 1])) return [];
  return [{ severity: 'warning', code: 'dt-moves-nothing', field: { kind: 'time', slot: at }, params: {} }];
}

function throttle({ idleThrottle }: TimerProgram): Finding[] {
  const value = idleThrottle ?? 0;
  if (value <= USUAL_THROTTLE || value > MAX_VALUE.idleThrottle) return [];
  const params = { limit: USUAL_THROTTLE };
  return [{ severity: 'warning', code: 'throttle-unusual', field: { kind: 'idleThrottle' }, params }];
}

function timerClass({ timerClass: letter }: Identity): Finding[] {
  if (letter === 'B' || letter === 'Q' || letter === 'E') return [];
  return [{ severity: 'warning', code: 'class-unknown', field: null, params: { timerClass: letter } }];
}
