import { fieldKey, MAX_VALUE, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import {
  type CellValue,
  checked,
  type Edit,
  type EditOutcome,
  type FieldValue,
  type Refusal,
  refusalOf,
  stepSize,
  type TextOption,
  type Unread,
} from './edit.js';
import {
  type CellField,
  cellKey,
  countedFrom,
  fieldsIn,
  type GridField,
  type GridRange,
  gridValue,
  intervalAt,
  programField,
  timeBefore,
} from './grid.js';
import { groupOf } from './history.js';

/**
 * The rules of a contest set DT, not the flight before it. So a shift of other times moves DT only on request, and any
 * other edit of them leaves it. The check finds functions that are pushed past DT.
 */
interface DtOption {
  readonly moveDt?: boolean;
}

/**
 * Sets an interval: the slot gets this distance from the one before, and later functions keep their own intervals. DT
 * stays, unless it is this slot.
 * @param slot not the start, which has no interval.
 * @param interval hundredths of a second. A negative one makes times fall.
 */
export function setInterval(program: TimerProgram, slot: number, interval: number, options: TextOption = {}): Edit {
  return ofInterval('type', slot, retime(program, new Map(), new Map([[slot, interval]]), options));
}

function ofInterval(how: 'type' | 'step', slot: number, outcome: EditOutcome): Edit {
  const group = groupOf(how, cellKey({ kind: 'interval', slot }));
  return { name: { code: 'change', params: { slot } }, group, ...outcome };
}

/**
 * Moves this and all later functions. From DT on, only DT moves; otherwise DT stays unless `moveDt` is set. From the
 * motor stop of a Q timer, the functions at its time or later move with it, because they follow it in flight.
 * @param slot the start only on a Q: on other classes its time is reserved.
 * @param by hundredths of a second; negative to earlier.
 */
export function shiftFrom(program: TimerProgram, slot: number, by: number, options: DtOption = {}): Edit {
  return { name: { code: 'shift', params: { slot, by } }, ...shifted(program, slot, by, options) };
}

/** The slots that {@link shiftFrom} moves, from `slot` on. */
export function slotsThatShift(
  { identity, times }: TimerProgram,
  slot: number,
  { moveDt = false }: DtOption = {},
): readonly number[] {
  const goesAlong = (time: number, at: number): boolean => {
    if (at === slot) return true;
    if (at === identity.functions) return moveDt;
    return slot === 0 ? time >= (times[slot] ?? 0) : at > slot;
  };
  return times.flatMap((time, at) => (goesAlong(time, at) ? [at] : []));
}

function shifted(program: TimerProgram, slot: number, by: number, options: DtOption): EditOutcome {
  const { times } = program;
  if (by === 0) return { values: [] };
  const moved = slotsThatShift(program, slot, options).map(
    (at): CellValue => ({ field: { kind: 'time', slot: at }, value: (times[at] as number) + by }),
  );
  return checked(program, moved);
}

/**
 * Goes steps up; with a negative number, down. The step of a time is the one in the manual, else 0.01 s; of any other
 * value 1. A value between two steps goes to the nearest step in that direction. Stops at 0 and at the largest value
 * that the wire carries; from outside this range it can only come back. Several steps in a row are one step to undo. A
 * text that is not a value cannot be stepped.
 */
export function stepValue(program: TimerProgram, field: ProgramField, by: number): Edit {
  const key = fieldKey(field);
  const values = nextStep(program, field, by);
  return { name: { code: 'change', params: { field: key } }, group: groupOf('step', key), values };
}

/** What of a servo a step moves. */
interface StepOfServo {
  readonly servo: number;
  /** How many steps up; negative: down. */
  readonly by: number;
  /** The first slot that moves with it, up to DT. 0 is the start: all of them. */
  readonly from: number;
}

/**
 * Steps all positions of a servo, as after its surface was mounted anew. Where one cannot go as far, it stops as in
 * {@link stepValue}, and {@link stopsOf} tells that before.
 */
export function stepServo(program: TimerProgram, step: StepOfServo): Edit {
  const values = positionsOf(program, step).flatMap(({ field }) => nextStep(program, field, step.by));
  return { name: { code: 'step-servo', params: { ...step } }, values };
}

/** Where positions stop on the way of {@link stepServo}, and the slots of those. */
export function stopsOf(program: TimerProgram, step: StepOfServo): ReadonlyMap<number, readonly number[]> {
  const stops = new Map<number, number[]>();
  for (const { field, value } of positionsOf(program, step)) {
    const [next = { value }] = nextStep(program, field, step.by);
    if (next.value !== value + step.by) stops.set(next.value, [...(stops.get(next.value) ?? []), field.slot]);
  }
  return stops;
}

/** The positions of a servo from a slot on. */
export function positionsOf(program: TimerProgram, { servo, from }: Omit<StepOfServo, 'by'>): readonly CellValue[] {
  const positions = program.positions[servo] ?? [];
  return positions.flatMap((value, slot) => (slot < from ? [] : [{ field: { kind: 'position', servo, slot }, value }]));
}

/** @returns an empty list when there is no step to take. */
function nextStep(program: TimerProgram, field: ProgramField, by: number): FieldValue[] {
  const before = valueAt(program, field);
  if (before === null) return [];
  const step = stepSize(program.identity, field);
  const last = Math.floor(MAX_VALUE[field.kind] / step) * step;
  const value = Math.min(Math.max(onStep(step, before, by), 0), last);
  return (value - before) * by > 0 ? [{ field, value }] : [];
}

/** The value so many steps on, also outside of what the wire carries. The first goes to the nearest whole step. */
export function onStep(step: number, before: number, by: number): number {
  return ((by > 0 ? Math.floor : Math.ceil)(before / step) + by) * step;
}

/**
 * Steps an interval as {@link stepValue} steps the time at its end, and moves later slots as {@link setInterval} does.
 * It never goes below 0.
 */
export function stepInterval(program: TimerProgram, slot: number, by: number, options: TextOption = {}): Edit {
  return ofInterval('step', slot, steppedInterval(program, slot, by, options));
}

function steppedInterval(program: TimerProgram, slot: number, by: number, { unreadable }: TextOption): EditOutcome {
  const from = countedFrom(slot);
  if (from && unreadable?.has(fieldKey(from))) return { refused: { code: 'unreadable', field: from } };
  const interval = intervalAt(program, slot);
  const [step] = nextStep(program, { kind: 'time', slot }, by);
  if (interval === null || !step) return { values: [] };
  const moved = step.value - (program.times[slot] as number);
  return shifted(program, slot, Math.max(moved, Math.min(0, -interval)), {});
}

/**
 * Steps all cells of a range as {@link stepValue} and {@link stepInterval} step one; several steps in a row are one to
 * undo. All of them go one step, or none does: the positions keep their distances. The time of the start stays, which
 * has no cell in its row.
 */
export function stepRange(program: TimerProgram, range: GridRange, by: number, options: TextOption = {}): Edit {
  const values: CellValue[] = [];
  const intervals = new Map<number, number>();
  for (const field of fieldsIn(program.identity, range)) {
    if (field.kind !== 'position' && field.slot === 0) continue;
    const target = programField(field);
    const before = valueAt(program, target);
    if (before === null) continue;
    const value = onStep(stepSize(program.identity, target), before, by);
    const interval = field.kind === 'interval' ? intervalAt(program, field.slot) : null;
    if (field.kind !== 'interval') values.push({ field, value });
    else if (interval !== null) {
      intervals.set(field.slot, interval + Math.max(value - before, Math.min(0, -interval)));
    }
  }
  const place = [range.top, range.left, range.bottom, range.right].join();
  return {
    ...ofCells('change', setCells(program, values, intervals, options)),
    group: groupOf('step', `range:${place}`),
  };
}

/**
 * Copies the first row of a range into its other rows: times (or intervals, where the range has no times) and
 * positions. The start has no function's time and no interval to copy. DT keeps its time. A text that is not a value
 * cannot be copied.
 */
export function fillDown(program: TimerProgram, range: GridRange, options: TextOption = {}): Edit {
  const { top } = range;
  const values: CellValue[] = [];
  const intervals = new Map<number, number>();
  for (const field of fieldsIn(program.identity, { ...range, top: top + 1 })) {
    const takesTime = top > 0 && field.slot < program.identity.functions;
    const from: GridField = { ...field, slot: top };
    const value = field.kind === 'position' || takesTime ? gridValue(program, from) : null;
    if (value === null) continue;
    const hidden = sourcesOf(from).find((source) => options.unreadable?.has(fieldKey(source)));
    if (hidden) return ofCells('fill', { refused: { code: 'unreadable', field: hidden } });
    if (field.kind === 'interval') intervals.set(field.slot, value);
    else values.push({ field, value });
  }
  return ofCells('fill', setCells(program, values, intervals, options));
}

/** An edit of many cells is named by their number. */
function ofCells(code: 'change' | 'fill', outcome: EditOutcome): Edit {
  const count = 'values' in outcome ? outcome.values.length : 0;
  return { name: { code, params: { count } }, ...outcome };
}

/** Sets values and intervals of cells: all of them, or none. */
function setCells(
  program: TimerProgram,
  values: readonly CellValue[],
  intervals: ReadonlyMap<number, number>,
  options: TextOption,
): EditOutcome {
  const spaced = retime(program, new Map(), intervals, options);
  return 'refused' in spaced ? spaced : checked(program, [...spaced.values, ...values]);
}

/** The fields that a cell's value comes from: for an interval, the time before it and the time at its end. */
function sourcesOf(field: GridField): CellField[] {
  const before = field.kind === 'interval' ? countedFrom(field.slot) : null;
  return before ? [before, programField(field)] : [programField(field)];
}

/**
 * Works out the times from given times and intervals, from the first slot to the last. A slot takes its given time;
 * else the time of the slot before plus its interval; else it moves as far as the nearest interval above moved its own
 * slot. DT stays unless it is given. The wire has to carry only the result. An interval never counts
 * from a time that cannot be read, and never moves one.
 * @param given times by slot. The wire's range is not checked here.
 * @param intervals by slot, from 1 on.
 * @returns the times; or a refusal with `cause`, the slot of the interval that led to it.
 */
export function retime(
  program: TimerProgram,
  given: ReadonlyMap<number, number>,
  intervals: ReadonlyMap<number, number>,
  { unreadable }: TextOption,
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
    } else if (slot < program.identity.functions) {
      value += by;
      if (by !== 0) hidden = field;
    }
    times[slot] = value;
    if (hidden && unreadable?.has(fieldKey(hidden))) return { refused: { code: 'unreadable', field: hidden }, cause };
    const refused = time === undefined && value !== before ? refusalOf(field, value) : null;
    if (refused) return { refused, cause };
    if (value !== before || time !== undefined || interval !== undefined) values.push({ field, value });
  }
  return { values };
}

/** The time that an interval counts from, as its field shows it; null when that is launch, or is given itself. */
export function startOf(
  slot: number,
  times: ReadonlyMap<number, number>,
  intervals: ReadonlyMap<number, number>,
): CellField | null {
  const from = countedFrom(slot);
  return from && !times.has(from.slot) && !intervals.has(from.slot) ? from : null;
}
