import {
  type FindingCode,
  fieldKey,
  fieldsOf,
  MAX_VALUE,
  manualRange,
  type ProgramField,
  type TimerProgram,
  valueAt,
  withValue,
} from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import type { CellField } from './grid.js';
import type { StepName } from './history.js';

/** A value for one field: times in hundredths of a second, positions in steps. */
export interface FieldValue {
  readonly field: ProgramField;
  readonly value: number;
}

/** The wire cannot carry a value: nothing was changed. */
export interface Refusal {
  /** As in the check. */
  readonly code: Extract<
    FindingCode,
    'time-not-whole' | 'time-out-of-range' | 'position-not-whole' | 'position-out-of-range'
  >;
  /** The field that refused its value. */
  readonly field: CellField;
  /** The refused value and the range of the field, as in a finding of the check. */
  readonly params: Readonly<Record<'value' | 'min' | 'max', number>>;
}

/** Why an edit cannot be done: a refused value, or a text that is not a value in a field that the edit needs. */
export type Obstacle = Refusal | Unread<ProgramField>;

/** The text in this field is not a value. */
export interface Unread<Field> {
  readonly code: 'unreadable';
  readonly field: Field;
}

/** Whose values they are, as far as a setting or a backup says it. */
export interface Owner {
  /** The setting that it belongs to; undefined for none. */
  readonly of?: SettingOf | undefined;
  /**
   * The id of the model whose backup was loaded into it, or {@link NOBODY}; undefined for none, or once a setting has
   * replaced it.
   */
  readonly backupOf?: string | undefined;
}

/** In place of the id of a model: nobody has said of which one the backup is. */
export const NOBODY = '';

/** A setting of the library: its id, and its content when it was last opened or saved here. */
export interface SettingOf {
  readonly id: string;
  readonly saved: TimerProgram;
}

/** The values of an edit. All of them together are one step. */
export interface EditValues {
  /** Includes values that equal the present ones, so that a text in such a field gives way. */
  readonly values: readonly FieldValue[];
  /**
   * The text that stands in these fields afterwards, by their keys; null for none, so that the value shows. In any
   * other field, a text that is not a value stops the edit, because the pilot may not see that field.
   */
  readonly texts?: Readonly<Record<string, string | null>>;
  /** Whose values the program has afterwards. Default: unchanged. */
  readonly owner?: Owner;
}

/** The values of an edit, or why it does nothing. It is done completely or not at all: no value is changed to fit. */
export type EditOutcome = EditValues | { readonly refused: Obstacle };

/** Something to do to the program, with its name for undo. {@link Editor.apply} does it. */
export type Edit = EditOutcome & {
  readonly name: StepName;
  /**
   * Edits of one group in a row are one step, until the field is left or the handle released.
   * Default: a step of its own.
   */
  readonly group?: string | undefined;
};

export interface TextOption {
  /**
   * The keys of fields whose text is not a value:
   * there the pilot sees something else than the program has. Default: none.
   */
  readonly unreadable?: Pick<ReadonlySet<string>, 'has'> | undefined;
}

/** The step of a value: for a time as in the manual, else a hundredth of a second; 1 for all others. */
export function stepSize(identity: Identity, field: ProgramField): number {
  return (field.kind === 'time' && manualRange(identity, field.slot)?.step) || 1;
}

/** Why the wire cannot carry a value in this field; null when it can. */
export function refusalOf(field: CellField, value: number): Refusal | null {
  const max = MAX_VALUE[field.kind];
  const isWhole = Number.isInteger(value);
  if (isWhole && value >= 0 && value <= max) return null;
  return { code: `${field.kind}-${isWhole ? 'out-of-range' : 'not-whole'}`, field, params: { value, min: 0, max } };
}

/** A copy of the program with these values. */
export function withValues(program: TimerProgram, values: readonly FieldValue[]): TimerProgram {
  return values.reduce((edited, { field, value }) => withValue(edited, field, value), program);
}

/** Sets values in fields that the pilot sees: any text there gives way. */
export function setValues(name: StepName, values: readonly FieldValue[], group?: string): Edit {
  return { name, group, values, texts: noTexts(values.map(({ field }) => field)) };
}

/**
 * Puts fields back to the values of a program. A field whose value is unknown there keeps its own;
 * a text in it gives way.
 */
export function putBack(name: StepName, to: TimerProgram, fields: readonly ProgramField[]): Edit {
  const values = fields.flatMap((field): FieldValue[] => {
    const value = valueAt(to, field);
    return value === null ? [] : [{ field, value }];
  });
  return { name, values, texts: noTexts(fields) };
}

/** Replaces everything that the pilot wants by another program of the same layout. */
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

/** Refused when a field would change to a value that the wire cannot carry. */
export function checked(program: TimerProgram, values: readonly CellValue[]): EditOutcome {
  for (const { field, value } of values) {
    const refused = value === valueAt(program, field) ? null : refusalOf(field, value);
    if (refused) return { refused };
  }
  return { values };
}
