import {
  type FindingCode,
  fieldKey,
  fieldsOf,
  type ProgramField,
  type TimerProgram,
  valueAt,
  withValue,
} from '../../program/index.js';
import { MAX_POSITION, MAX_TIME } from '../../protocol/index.js';
import type { SettingOf } from './content.js';
import type { CellField } from './grid.js';
import type { StepName } from './history.js';

/** A value for one field: a time in hundredths of a second, a position in steps. */
export interface FieldValue {
  readonly field: ProgramField;
  readonly value: number;
}

/**
 * Why nothing was changed.
 *
 * - `time-not-whole`, `time-out-of-range`, `position-not-whole`, `position-out-of-range`: the wire could not carry the
 *   value, as the check would find.
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

/** Why an edit is not done: it cannot be, or a text that is not a value yet stands where it would read or write. */
export type Obstacle = Refusal | Unread<ProgramField>;

/** The text in this field is not a value. */
export interface Unread<Field> {
  readonly code: 'unreadable';
  readonly field: Field;
}

/** What an edit does to the program, all of it as one step. */
export interface EditValues {
  /** What was asked for is in the list also where it is the value already, so that a text in such a field gives way. */
  readonly values: readonly FieldValue[];
  /**
   * What stands in these fields afterwards, by their keys, whatever text stands there now: a text as it was typed, or
   * null for the value. In any other field a text that is not a value is in the way of an edit: the pilot may not see
   * that field.
   */
  readonly texts?: Readonly<Record<string, string | null>>;
  /** The setting that the program belongs to from then on. Default: the one that it belongs to. */
  readonly of?: SettingOf | undefined;
  /** The model whose backup it is, by its id. Default: the one that it was of. */
  readonly backupOf?: string | undefined;
}

/** What an edit does, or why it does nothing. It is done whole or not at all: no value is bent to fit. */
export type EditOutcome = EditValues | { readonly refused: Obstacle };

/** Something to be done to the program, and what undo calls it. {@link Editor.apply} does it. */
export type Edit = EditOutcome & {
  readonly name: StepName;
  /**
   * Edits of one group that follow each other are one step, until the field is left or the handle let go. Default: a
   * step of its own.
   */
  readonly group?: string | undefined;
};

export interface TextOption {
  /**
   * The keys of the fields whose text is not a value: what the program has there is not what the pilot sees. Default:
   * none.
   */
  readonly unreadable?: Pick<ReadonlySet<string>, 'has'> | undefined;
}

export const NONE_UNREADABLE: ReadonlySet<string> = new Set();

const MAX_THROTTLE = 255;
/** The largest value that the wire carries in a kind of field. */
export const MAX_VALUE = { time: MAX_TIME, position: MAX_POSITION, idleThrottle: MAX_THROTTLE };

/** Why the wire cannot carry a value in this field; null when it can. */
export function refusalOf(field: CellField, value: number): Refusal | null {
  if (!Number.isInteger(value)) return refusal(`${field.kind}-not-whole`, field, value);
  return value >= 0 && value <= MAX_VALUE[field.kind] ? null : refusal(`${field.kind}-out-of-range`, field, value);
}

export function refusal(code: RefusalCode, field: CellField, value: number): Refusal {
  return { code, field, params: { value, min: 0, max: MAX_VALUE[field.kind] } };
}

/** The program with these values in it. */
export function withValues(program: TimerProgram, values: readonly FieldValue[]): TimerProgram {
  return values.reduce((edited, { field, value }) => withValue(edited, field, value), program);
}

/** Values that were chosen for fields that the pilot sees: whatever text stands there gives way. */
export function setValues(name: StepName, values: readonly FieldValue[], group?: string): Edit {
  return { name, group, values, texts: noTexts(values.map(({ field }) => field)) };
}

/**
 * Puts fields back to what a program has there. One that is not known there keeps its value; a text in it gives way.
 */
export function putBack(name: StepName, to: TimerProgram, fields: readonly ProgramField[]): Edit {
  const values = fields.flatMap((field): FieldValue[] => {
    const value = valueAt(to, field);
    return value === null ? [] : [{ field, value }];
  });
  return { name, values, texts: noTexts(fields) };
}

/** Puts a whole program in place of what the pilot wants. Both have the same layout. */
export function replaceAll(name: StepName, program: TimerProgram): Edit {
  return putBack(name, program, fieldsOf(program.identity));
}

function noTexts(fields: readonly ProgramField[]): Readonly<Record<string, null>> {
  return Object.fromEntries(fields.map((field) => [fieldKey(field), null]));
}

/** A value for a cell of the grid. */
export interface CellValue extends FieldValue {
  readonly field: CellField;
}

/** Refused when a field would be changed to a value that the wire cannot carry. */
export function checked(program: TimerProgram, values: readonly CellValue[]): EditOutcome {
  for (const { field, value } of values) {
    const refused = value === valueAt(program, field) ? null : refusalOf(field, value);
    if (refused) return { refused };
  }
  return { values };
}
