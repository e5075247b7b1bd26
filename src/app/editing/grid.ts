import { fieldKey, type ProgramField, type TimerProgram, valueAt } from '../../program/index.js';
import { type Identity, slotCount } from '../../protocol/index.js';

/**
 * A cell of the program's grid, which is like the table on the screen. Each slot has a row, from start to DT; across it
 * stand the time, the interval, then each servo. Rows and columns count from 0.
 */
export interface GridCell {
  readonly row: number;
  readonly column: number;
}

/** A rectangle of the grid, with its edges. */
export interface GridRange {
  readonly top: number;
  readonly left: number;
  readonly bottom: number;
  readonly right: number;
}

export const TIME_COLUMN = 0;
export const INTERVAL_COLUMN = 1;
export const FIRST_SERVO_COLUMN = 2;

/** A value of the program that has a cell in the grid. */
export type CellField = Exclude<ProgramField, { kind: 'idleThrottle' }>;
/** The content of a cell: a value of the program, or an interval, which shows a time relative to the one before. */
export type GridField = CellField | { readonly kind: 'interval'; readonly slot: number };

/** How many columns the grid has: time, interval, servos. */
export function gridColumns(identity: Identity): number {
  return FIRST_SERVO_COLUMN + identity.servos;
}

/** The content of a cell; null outside of the grid, and for the interval of the start, which has no slot before it. */
export function gridField(identity: Identity, { row, column }: GridCell): GridField | null {
  if (row < 0 || row >= slotCount(identity) || column < 0 || column >= gridColumns(identity)) return null;
  if (column === TIME_COLUMN) return { kind: 'time', slot: row };
  if (column === INTERVAL_COLUMN) return row === 0 ? null : { kind: 'interval', slot: row };
  return { kind: 'position', servo: column - FIRST_SERVO_COLUMN, slot: row };
}

/** The cell of a field; null for a value without one. */
export function cellFor(field: ProgramField | GridField): GridCell | null {
  if (field.kind === 'idleThrottle') return null;
  if (field.kind === 'position') return { row: field.slot, column: FIRST_SERVO_COLUMN + field.servo };
  return { row: field.slot, column: field.kind === 'time' ? TIME_COLUMN : INTERVAL_COLUMN };
}

/** The value that an entry in a cell changes: for an interval, the time at its end. */
export function programField(field: GridField): CellField {
  return field.kind === 'interval' ? { kind: 'time', slot: field.slot } : field;
}

/** A short name of what stands in a cell, as {@link fieldKey} gives one of a value. */
export function cellKey(field: ProgramField | GridField): string {
  return field.kind === 'interval' ? `interval:${field.slot}` : fieldKey(field);
}

/**
 * The slot before whose row the motor stop of a Q stands: they are in the order of time. A function at the same time
 * comes after it, because it moves with the motor stop. One more than the last slot when it comes after DT; null on
 * other classes.
 */
export function motorRow({ identity, times }: TimerProgram): number | null {
  if (identity.timerClass !== 'Q') return null;
  const next = times.findIndex((time, slot) => slot > 0 && time >= (times[0] ?? 0));
  return next < 0 ? times.length : next;
}

/** The rectangle with these two corners, in either order. */
export function rangeBetween(a: GridCell, b: GridCell): GridRange {
  return {
    top: Math.min(a.row, b.row),
    left: Math.min(a.column, b.column),
    bottom: Math.max(a.row, b.row),
    right: Math.max(a.column, b.column),
  };
}

export function isInRange(range: GridRange | null, { row, column }: GridCell): boolean {
  return range !== null && row >= range.top && row <= range.bottom && column >= range.left && column <= range.right;
}

/**
 * The grid columns of a range, from left to right, as far as they exist. Without the intervals where the range also has
 * the times: they show the same.
 */
export function columnsIn(identity: Identity, { left, right }: GridRange): number[] {
  const last = Math.min(right, gridColumns(identity) - 1);
  const all = Array.from({ length: Math.max(0, last - left + 1) }, (_, at) => left + at);
  return all.filter((column) => column !== INTERVAL_COLUMN || left > TIME_COLUMN);
}

/** The rows of a range, from top to bottom, as far as they exist. */
export function rowsIn(identity: Identity, { top, bottom }: GridRange): number[] {
  const last = Math.min(bottom, slotCount(identity) - 1);
  return Array.from({ length: Math.max(0, last - top + 1) }, (_, at) => top + at);
}

/** The contents of a range, row by row. Without the intervals where the range also has the times. */
export function fieldsIn(identity: Identity, range: GridRange): GridField[] {
  const columns = columnsIn(identity, range);
  return rowsIn(identity, range).flatMap((row) =>
    columns.map((column) => gridField(identity, { row, column })).filter((field) => field !== null),
  );
}

/**
 * The time from the slot before to this one, in hundredths of a second. For function 1 (or DT without functions), the
 * time from launch. Negative where times fall. Null for the start: its time is the motor stop, or reserved, and nothing
 * counts from it.
 */
export function intervalAt({ times }: TimerProgram, slot: number): number | null {
  const time = times[slot];
  return slot < 1 || time === undefined ? null : time - timeBefore(times, slot);
}

/** The field that a slot's interval counts from; null when it counts from launch. */
export function countedFrom(slot: number): CellField | null {
  return slot > 1 ? { kind: 'time', slot: slot - 1 } : null;
}

/** What a cell holds: times and intervals in hundredths of a second, positions in steps. Null where it is not known. */
export function gridValue(program: TimerProgram, field: GridField): number | null {
  return field.kind === 'interval' ? intervalAt(program, field.slot) : valueAt(program, field);
}

/** The time that a slot's interval counts from: the time of the slot before, or launch. */
export function timeBefore(times: readonly number[], slot: number): number {
  const from = countedFrom(slot);
  return from ? (times[from.slot] as number) : 0;
}
