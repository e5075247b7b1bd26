import {
  type Change,
  differences,
  fieldKey,
  fieldsOf,
  type ProgramField,
  type TimerProgram,
  valueAt,
} from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { type FieldValue, withValues } from './edits.js';
import { formatTime, parseSteps, type Question, type Reading, readTime, type UnreadableReason } from './units.js';

/** What the pilot wants, and the texts in fields as they were typed, by field: what an edit changes and undo brings back. */
export interface Content {
  readonly working: TimerProgram;
  readonly texts: Readonly<Record<string, string>>;
}

/** A field whose text is no value. */
export interface UnreadableField {
  readonly field: ProgramField;
  readonly reason: UnreadableReason;
  /** What it may mean, where it is ambiguous. */
  readonly either?: Question['either'] | undefined;
}

/** What a text in a field says. */
export function parseValue({ functions }: Identity, field: ProgramField, text: string): Reading {
  return field.kind === 'time' ? readTime(text, { isDt: field.slot === functions }) : parseSteps(text);
}

/** A value in the form in which a pilot reads and types it. */
export function formatValue(field: ProgramField, value: number): string {
  return field.kind === 'time' ? formatTime(value) : String(value);
}

/** The texts that are no values, first to last field. */
export function unreadableIn({ working, texts }: Content): Map<string, UnreadableField> {
  const found = new Map<string, UnreadableField>();
  if (Object.keys(texts).length === 0) return found;
  for (const field of fieldsOf(working.identity)) {
    const text = texts[fieldKey(field)];
    const parsed = text === undefined ? null : parseValue(working.identity, field, text);
    if (!parsed || 'value' in parsed) continue;
    const either = 'either' in parsed ? parsed.either : undefined;
    found.set(fieldKey(field), { field, reason: parsed.unreadable, either });
  }
  return found;
}

/** Whether two contents mean the same in every field: a text that is a value counts as that value. */
export function meansSame(a: Content, b: Content): boolean {
  const unreadable = (content: Content): string =>
    JSON.stringify([...unreadableIn(content).keys()].map((key) => [key, content.texts[key]]));
  return differences(a.working, b.working).length === 0 && unreadable(a) === unreadable(b);
}

/**
 * A text as it was typed, and its value if it has one. One that asks what it means has none: the field is worth again what it was before.
 * @param before the program before anything was typed there: on the way to `230` stood `23`.
 */
export function typed({ working, texts }: Content, field: ProgramField, text: string, before: TimerProgram): Content {
  const parsed = parseValue(working.identity, field, text);
  const value = 'value' in parsed ? parsed.value : 'either' in parsed ? valueAt(before, field) : null;
  return {
    working: value === null ? working : withValues(working, [{ field, value }]),
    texts: { ...texts, [fieldKey(field)]: text },
  };
}

/** These values, in the place of whatever texts stood in their fields. */
export function applied({ working, texts }: Content, values: readonly FieldValue[]): Content {
  const changes = values.filter(({ field, value }) => valueAt(working, field) !== value);
  return {
    working: withValues(working, changes),
    texts: without(
      texts,
      values.map(({ field }) => fieldKey(field)),
    ),
  };
}

/** These fields as they are in another program; one that is not known there stays. */
export function valuesOf(program: TimerProgram, fields: readonly ProgramField[]): FieldValue[] {
  return fields.flatMap((field) => {
    const value = valueAt(program, field);
    return value === null ? [] : [{ field, value }];
  });
}

/** These fields as a program has them, in the place of whatever stood there. */
export function putBack(content: Content, to: TimerProgram, fields: readonly ProgramField[]): Content {
  const { working, texts } = applied(content, valuesOf(to, fields));
  return { working, texts: without(texts, fields.map(fieldKey)) };
}

/** Fields that nobody had touched follow the timer to what it holds now, and so do texts that say what it held. */
export function followed({ working, texts }: Content, moved: readonly Change[], read: TimerProgram): Content {
  const untouched = moved.flatMap(({ field, from, to }): FieldValue[] =>
    to !== null && valueAt(working, field) === from ? [{ field, value: to }] : [],
  );
  const unreadable = unreadableIn({ working, texts });
  const said = untouched.map(({ field }) => fieldKey(field)).filter((key) => !unreadable.has(key));
  const { memory } = read;
  const idleThrottle = working.idleThrottle ?? read.idleThrottle;
  return { working: { ...withValues(working, untouched), memory, idleThrottle }, texts: without(texts, said) };
}

/** Conflicts by field, after another reading: what counts is what was held when the edits were made. */
export function conflictsWith(
  known: ReadonlyMap<string, Change>,
  changes: readonly Change[],
): ReadonlyMap<string, Change> {
  const noted = new Map(known);
  for (const change of changes) {
    const key = fieldKey(change.field);
    noted.set(key, { ...change, from: noted.get(key)?.from ?? change.from });
  }
  return new Map([...noted].filter(([, { from, to }]) => from !== to));
}

/** Texts of fields that a program has; others, as a file may hold them, are dropped. */
export function textsFor({ identity }: TimerProgram, texts: Content['texts']): Content['texts'] {
  const keys = fieldsOf(identity).map(fieldKey);
  return Object.fromEntries(keys.filter((key) => Object.hasOwn(texts, key)).map((key) => [key, texts[key] as string]));
}

/** Texts without those of some fields; the same object when there were none. */
export function without(texts: Content['texts'], keys: readonly string[]): Content['texts'] {
  if (!keys.some((key) => Object.hasOwn(texts, key))) return texts;
  const dropped = new Set(keys);
  return Object.fromEntries(Object.entries(texts).filter(([key]) => !dropped.has(key)));
}
