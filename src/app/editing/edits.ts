import {
  type FindingCode,
  fieldKey,
  manualRange,
  type ProgramField,
  type TimerProgram,
  valueAt,
  withValue,
} from '../../program/index.js';
import { MAX_POSITION, MAX_TIME } from '../../protocol/index.js';
import {
  type CellField,
  countedFrom,
  fieldsIn,
  type GridField,
  type GridRange,
  intervalAt,
  programField,
  timeBefore,
} from './grid.js';

/** A value for one field: a time in hundredths of a second, a position in steps. */
export interface FieldValue {
  readonly field: ProgramField;
  readonly value: number;
}

/**
 * Why nothing was changed.
 *
 * - `time-not-whole`, `time-out-of-range`, `position-not-whole`, `position-out-of-range`: the wire could not carry the value, as the check
 *   would find.
 * - `reserved`: slot 0 of a class other than Q, which is edited only on purpose, as a field of its own.
 * - `no-interval`: the start follows nothing.
 */
export type RefusalCode =
  | Extract<FindingCode, 'time-not-whole' | 'time-out-of-range' | 'position-not-whole' | 'position-out-of-range'>
  | 'reserved'
  | 'no-interval';

export interface Refusal {
  readonly code: RefusalCode;
  /** The field that could not take its value. */
  readonly field: CellField;
  /** What the field would have been, and its range, as in a finding of the check. */
  readonly params: Readonly<Record<'value' | 'min' | 'max', number>>;
}

/** Why an edit was not done: it cannot be, or a text that is no value yet stands where it would read or write. */
export type Obstacle = Refusal | Unread<ProgramField>;

/** The text in this field is no value. */
export interface Unread<Field> {
  readonly code: 'unreadable';
  readonly field: Field;
}

/**
 * What an edit sets, or why it sets nothing. An edit is done whole or not at all: no value is bent to fit. What was asked for is in the
 * list also where it is the value already, so that a text in such a field gives way.
 */
export type Edit = { readonly values: readonly FieldValue[] } | { readonly refused: Obstacle };

/**
 * DT is set by the rules of a contest, not by what the model does before it: an edit of other times moves it only when asked.
 * Functions that are pushed past it are found by the check.
 */
export interface DtOption {
  readonly moveDt?: boolean;
}

export interface TextOption {
  /** The keys of the fields whose text is no value: what the program has there is not what the pilot sees. Default: none. */
  readonly unreadable?: Pick<ReadonlySet<string>, 'has'> | undefined;
}

const NONE_UNREADABLE: ReadonlySet<string> = new Set();

const MAX_THROTTLE = 255;
/** The largest value that the wire carries in a kind of field. */
export const MAX_VALUE = { time: MAX_TIME, position: MAX_POSITION, idleThrottle: MAX_THROTTLE };

/** Why the wire cannot carry a value in this field; null when it can. */
export function refusalOf(field: CellField, value: number): Refusal | null {
  if (!Number.isInteger(value)) return refusal(`${field.kind}-not-whole`, field, value);
  return value >= 0 && value <= MAX_VALUE[field.kind] ? null : refusal(`${field.kind}-out-of-range`, field, value);
}

function refusal(code: RefusalCode, field: CellField, value: number): Refusal {
  return { code, field, params: { value, min: 0, max: MAX_VALUE[field.kind] } };
}

/** The program with these values in it. */
export function withValues(program: TimerProgram, values: readonly FieldValue[]): TimerProgram {
  return values.reduce((edited, { field, value }) => withValue(edited, field, value), program);
}

/**
 * Sets an interval: the slot keeps this distance to the one before it, and the functions after it keep theirs, as on a sheet of
 * intervals. DT stays unless it is this slot or `moveDt` is set.
 * @param interval hundredths of a second; a negative one makes times fall.
 */
export function setInterval(program: TimerProgram, slot: number, interval: number, options: DtOption = {}): Edit {
  if (slot === 0) return { refused: refusal('no-interval', { kind: 'time', slot }, interval) };
  return retime(program, new Map(), new Map([[slot, interval]]), options);
}

/**
 * Moves this and all later functions. From DT only DT is moved; else it stays unless `moveDt` is set. From the motor stop of a Q
 * timer those functions go along that are at its time or later, for they follow it in flight.
 * @param by hundredths of a second, negative to earlier.
 */
export function shiftFrom(program: TimerProgram, slot: number, by: number, { moveDt = false }: DtOption = {}): Edit {
  const { identity, times } = program;
  const from = times[slot];
  if (from === undefined || by === 0) return { values: [] };
  if (slot === 0 && identity.timerClass !== 'Q') {
    return { refused: refusal('reserved', { kind: 'time', slot }, from + by) };
  }
  const goesAlong = (time: number, at: number): boolean => {
    if (at === slot) return true;
    if (at === identity.functions) return moveDt;
    return slot === 0 ? time >= from : at > slot;
  };
  const moved = times.flatMap((time, at): CellValue[] =>
    goesAlong(time, at) ? [{ field: { kind: 'time', slot: at }, value: time + by }] : [],
  );
  return checked(program, moved);
}

export interface StepOptions {
  /** Ten steps at once. */
  readonly tenfold?: boolean;
}

/**
 * One step up or down: of a time the step that the manual gives for it, else 0.01 s; of all else 1. A value between two steps goes to the
 * next one. It ends at 0 and at the last step that the wire carries; a value past them can only come back.
 * @returns nothing when there is no step to take.
 */
export function stepValue(
  program: TimerProgram,
  field: ProgramField,
  direction: 1 | -1,
  { tenfold = false }: StepOptions = {},
): FieldValue[] {
  const before = valueAt(program, field);
  if (before === null) return [];
  const step = (field.kind === 'time' && manualRange(program.identity, field.slot)?.step) || 1;
  const last = Math.floor(MAX_VALUE[field.kind] / step);
  const steps = (direction > 0 ? Math.floor : Math.ceil)(before / step) + direction * (tenfold ? 10 : 1);
  const value = Math.min(Math.max(steps, 0), last) * step;
  return (value - before) * direction > 0 ? [{ field, value }] : [];
}

/**
 * Steps an interval as {@link stepValue} steps the time at its end, and moves what follows as {@link setInterval} does. It is never
 * stepped below 0.
 */
export function stepInterval(
  program: TimerProgram,
  slot: number,
  direction: 1 | -1,
  options: StepOptions & DtOption = {},
): Edit {
  const interval = intervalAt(program, slot);
  const [step] = stepValue(program, { kind: 'time', slot }, direction, options);
  if (interval === null || !step) return { values: [] };
  const by = step.value - (program.times[slot] as number);
  return shiftFrom(program, slot, Math.max(by, Math.min(0, -interval)), options);
}

/** Gives one servo all positions of another. A position past the last step, as a timer may hold it, can be given to no other. */
export function copyServo(program: TimerProgram, from: number, to: number): Edit {
  const row = program.positions[from] ?? [];
  return checked(
    program,
    row.map((value, slot) => ({ field: { kind: 'position', servo: to, slot }, value })),
  );
}

/** Mirrors all positions of a servo, 130 - p, as when it works the other way round. What is no step stays as it is. */
export function reverseServo(program: TimerProgram, servo: number): FieldValue[] {
  const row = program.positions[servo] ?? [];
  return row.flatMap((value, slot): FieldValue[] => {
    const field: CellField = { kind: 'position', servo, slot };
    return refusalOf(field, value) ? [] : [{ field, value: MAX_POSITION - value }];
  });
}

/**
 * Puts the values of the first row of a range into its other rows: times, or intervals where no times are in it, and positions. The start
 * has neither the time of a function nor an interval to give, and DT keeps its time unless `moveDt` is set. A text that is no value has
 * nothing to give.
 */
export function fillDown(program: TimerProgram, range: GridRange, options: DtOption & TextOption = {}): Edit {
  const { functions } = program.identity;
  const { unreadable = NONE_UNREADABLE } = options;
  const takesTime = (slot: number): boolean => range.top > 0 && (slot < functions || options.moveDt === true);
  const copies: CellValue[] = [];
  const intervals = new Map<number, number>();
  for (const field of fieldsIn(program.identity, { ...range, top: range.top + 1 })) {
    if (field.kind !== 'position' && !takesTime(field.slot)) continue;
    const value =
      field.kind === 'interval' ? intervalAt(program, range.top) : valueAt(program, { ...field, slot: range.top });
    if (value === null) continue;
    const hidden = sourcesOf({ ...field, slot: range.top }).find((source) => unreadable.has(fieldKey(source)));
    if (hidden) return { refused: { code: 'unreadable', field: hidden } };
    if (field.kind === 'interval') intervals.set(field.slot, value);
    else copies.push({ field, value });
  }
  const spaced = retime(program, new Map(), intervals, options);
  return 'refused' in spaced ? spaced : checked(program, [...spaced.values, ...copies]);
}

/** What the value of a cell is read from: an interval from the time that it counts from and the one at its end. */
function sourcesOf(field: GridField): CellField[] {
  const before = field.kind === 'interval' ? countedFrom(field.slot) : null;
  return before ? [before, programField(field)] : [programField(field)];
}

/**
 * The times that follow from given times and intervals, first to last: a slot takes its time, else its interval after the one before,
 * else it is moved as far as the nearest interval above moved its own slot. DT without either stays unless `moveDt` is set. Only what
 * comes out has to be carried by the wire, not what would be on the way there. No interval counts from a time that cannot be read, and none
 * moves one.
 * @param given times by slot; whether the wire carries them is not looked at.
 * @param intervals by slot, from 1 on.
 * @returns with a refusal also `cause`, the slot of the interval that led to it.
 */
export function retime(
  program: TimerProgram,
  given: ReadonlyMap<number, number>,
  intervals: ReadonlyMap<number, number>,
  { moveDt = false, unreadable = NONE_UNREADABLE }: DtOption & TextOption = {},
):
  | { readonly values: readonly CellValue[] }
  | { readonly refused: Refusal | Unread<CellField>; readonly cause: number } {
  const times = [...program.times];
  const values: CellValue[] = [];
  let by = 0;
  let cause = 0;
  for (const [slot, before] of program.times.entries()) {
    const field: CellField = { kind: 'time', slot };
    const time = given.get(slot);
    const interval = intervals.get(slot);
    let value = before;
    let hidden: CellField | null = null;
    if (time !== undefined) value = time;
    else if (interval !== undefined) {
      hidden = startOf(slot, given, intervals);
      value = timeBefore(times, slot) + interval;
      by = value - before;
      cause = slot;
    } else if (slot < program.identity.functions || moveDt) {
      value += by;
      if (by !== 0) hidden = field;
    }
    times[slot] = value;
    if (hidden && unreadable.has(fieldKey(hidden))) return { refused: { code: 'unreadable', field: hidden }, cause };
    const refused = time === undefined && value !== before ? refusalOf(field, value) : null;
    if (refused) return { refused, cause };
    if (value !== before || time !== undefined || interval !== undefined) values.push({ field, value });
  }
  return { values };
}

/** The time that an interval counts from as it stands in its field: null where that is launch, or is itself given. */
export function startOf(
  slot: number,
  times: ReadonlyMap<number, number>,
  intervals: ReadonlyMap<number, number>,
): CellField | null {
  const from = countedFrom(slot);
  return from && !times.has(from.slot) && !intervals.has(from.slot) ? from : null;
}

interface CellValue extends FieldValue {
  readonly field: CellField;
}

/** Refused when a field would be changed to a value that the wire cannot carry. */
function checked(program: TimerProgram, values: readonly CellValue[]): Edit {
  for (const { field, value } of values) {
    const refused = value === valueAt(program, field) ? null : refusalOf(field, value);
    if (refused) return { refused };
  }
  return { values };
}
