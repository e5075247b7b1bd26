import { CodecError, columnCount, type Identity } from '../protocol/index.js';

/**
 * What a pilot sets: the content of one memory. Columns are start, function 1 .. NF-1, DT, as many as the identity says.
 */
export interface TimerProgram {
  readonly identity: Identity;
  /** The memory that it was read from, counted from 0; null when the timer does not say. */
  readonly memory: number | null;
  /**
   * The time of each column in hundredths of a second, 0..65535, absolute from launch. Column 0 is the motor stop on class Q
   * and reserved on B and E.
   */
  readonly timers: readonly number[];
  /** `[servo][column]`, steps 0..130. A timer may hold 131..255; such a value is kept as it was read. */
  readonly positions: readonly (readonly number[])[];
  /** 0..255, unit unknown; null when it was not read (any class but Q) or the timer did not answer. */
  readonly idleThrottle: number | null;
}

/** Names one value of a program. Columns and servos count from 0. */
export type ProgramField =
  | { readonly kind: 'time'; readonly column: number }
  | { readonly kind: 'position'; readonly servo: number; readonly column: number }
  | { readonly kind: 'idleThrottle' };

/** What a column is: `start` is column 0, `dt` the last, `function` each one between. */
export function columnKind(identity: Identity, column: number): 'start' | 'function' | 'dt' {
  if (column === 0) return 'start';
  return column === identity.functions ? 'dt' : 'function';
}

/** All fields of a program for this timer: the times, the positions servo by servo, the idle throttle. */
export function fieldsOf(identity: Identity): ProgramField[] {
  const columns = Array.from({ length: columnCount(identity) }, (_, column) => column);
  const servos = Array.from({ length: identity.servos }, (_, servo) => servo);
  return [
    ...columns.map((column): ProgramField => ({ kind: 'time', column })),
    ...servos.flatMap((servo) => columns.map((column): ProgramField => ({ kind: 'position', servo, column }))),
    { kind: 'idleThrottle' },
  ];
}

/** A short name of a field, the same for equal fields: `time:3`, `position:0:3`, `idleThrottle`. */
export function fieldKey(field: ProgramField): string {
  if (field.kind === 'time') return `time:${field.column}`;
  if (field.kind === 'position') return `position:${field.servo}:${field.column}`;
  return field.kind;
}

/** The value of a field; null for an idle throttle that is not known. */
export function valueAt(program: TimerProgram, field: ProgramField): number | null {
  if (field.kind === 'time') return program.timers[field.column] ?? null;
  if (field.kind === 'position') return program.positions[field.servo]?.[field.column] ?? null;
  return program.idleThrottle;
}

/** A copy of the program in which one field has another value. */
export function withValue(program: TimerProgram, field: ProgramField, value: number): TimerProgram {
  const replaced = (list: readonly number[], index: number): number[] =>
    list.map((old, i) => (i === index ? value : old));
  if (field.kind === 'time') return { ...program, timers: replaced(program.timers, field.column) };
  if (field.kind === 'idleThrottle') return { ...program, idleThrottle: value };
  const positions = program.positions.map((row, servo) => (servo === field.servo ? replaced(row, field.column) : row));
  return { ...program, positions };
}

/** Whether two timers are of one class, firmware and layout. It does not mean that they are the same timer. */
export function sameKind(a: Identity, b: Identity): boolean {
  return a.timerClass === b.timerClass && a.firmware === b.firmware && sameLayout(a, b) && a.memories === b.memories;
}

/** Whether programs of two timers have the same columns and servos. */
export function sameLayout(a: Identity, b: Identity): boolean {
  return a.functions === b.functions && a.servos === b.servos;
}

/**
 * Makes sure that the lists of a program have the shape that its identity gives.
 * @throws CodecError `wrong-count`.
 */
export function requireShape(program: TimerProgram): void {
  const columns = columnCount(program.identity);
  const require = (list: readonly unknown[], field: string, count: number): void => {
    if (list.length === count) return;
    throw new CodecError('wrong-count', field, `${field} must have ${count} entries, not ${list.length}`, {
      value: list.length,
      min: count,
      max: count,
    });
  };
  require(program.timers, 'timers', columns);
  require(program.positions, 'positions', program.identity.servos);
  program.positions.forEach((row, servo) => {
    require(row, `positions[${servo}]`, columns);
  });
}
