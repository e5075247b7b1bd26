import {
  type Change,
  differences,
  fieldKey,
  fieldsOf,
  manualRange,
  type ProgramField,
  type TimerProgram,
  valueAt,
} from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';
import { type EditValues, type FieldValue, withValues } from './edit.js';
import {
  type Ambiguous,
  type Figure,
  formatFigure,
  formatTime,
  parseSteps,
  readTime,
  type TypedText,
  type UnreadableReason,
} from './units.js';

/**
 * What the pilot wants, and the texts in fields as they were typed, by field: what an edit changes and undo brings
 * back.
 */
export interface Content {
  readonly working: TimerProgram;
  readonly texts: Readonly<Record<string, string>>;
  /** The setting that it belongs to; undefined: to none. */
  readonly of?: SettingOf | undefined;
  /** The model of which a backup was loaded into it, by its id; undefined: of none, or a setting has come since. */
  readonly backupOf?: string | undefined;
}

/** A setting of the library, by its id, and what it held when it was opened or saved here last. */
export interface SettingOf {
  readonly id: string;
  readonly saved: TimerProgram;
}

/** A field whose text is not a value. */
export interface UnreadableField {
  readonly field: ProgramField;
  readonly reason: UnreadableReason;
  /** What it may mean, where it is ambiguous. */
  readonly either?: Ambiguous['either'] | undefined;
}

/** What a text in a field says. */
export function parseValue({ functions }: Identity, field: ProgramField, text: string): TypedText {
  return field.kind === 'time' ? readTime(text, { isDt: field.slot === functions }) : parseSteps(text);
}

/**
 * A value in the form in which a pilot reads and types it. The motor stop has the form of the large figure, `10.0`. A
 * DT has not: `12` without its unit may be 12 s or 12 min.
 */
export function formatValue(identity: Identity, field: ProgramField, value: number): string {
  if (field.kind !== 'time') return String(value);
  const isMotorStop = field.slot === 0 && identity.timerClass === 'Q';
  return isMotorStop ? figureOfTime(identity, 0, value).text : formatTime(value);
}

/** A time as a large figure, with the decimals of the step in which it is set. */
export function figureOfTime(identity: Identity, slot: number, value: number): Figure {
  const isDt = slot === identity.functions;
  return formatFigure(value, isDt ? 100 : (manualRange(identity, slot)?.step ?? 1));
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
  return a.of?.id === b.of?.id && differences(a.working, b.working).length === 0 && unreadable(a) === unreadable(b);
}

/**
 * The value of a text that was typed; null when it has none. One that asks what it means has none: the field is worth
 * again what it was before.
 * @param before the program before anything was typed there: on the way to `230` stood `23`.
 */
export function valueOfText(field: ProgramField, text: string, before: TimerProgram): number | null {
  const parsed = parseValue(before.identity, field, text);
  if ('value' in parsed) return parsed.value;
  return 'either' in parsed ? valueAt(before, field) : null;
}

/**
 * The field in which a text stands that is not a value, where an edit would put something else without the pilot seeing
 * it.
 */
export function inTheWay(unreadable: ReadonlyMap<string, unknown>, edit: EditValues): ProgramField | null {
  const { texts = {} } = edit;
  const isHidden = (key: string): boolean => unreadable.has(key) && !Object.hasOwn(texts, key);
  return edit.values.find(({ field }) => isHidden(fieldKey(field)))?.field ?? null;
}

/** What an edit makes of it; the same objects where that is what was there. */
export function applied({ working, texts, of, backupOf }: Content, edit: EditValues): Content {
  const changes = edit.values.filter(({ field, value }) => valueAt(working, field) !== value);
  const replaced = edit.texts ?? {};
  const left = without(texts, [...edit.values.map(({ field }) => fieldKey(field)), ...Object.keys(replaced)]);
  const typed = Object.entries(replaced).filter((entry): entry is [string, string] => entry[1] !== null);
  return {
    working: withValues(working, changes),
    texts: typed.length > 0 ? { ...left, ...Object.fromEntries(typed) } : left,
    of: edit.of ?? of,
    backupOf: edit.backupOf ?? (edit.of ? undefined : backupOf),
  };
}

/**
 * What the pilot wants, on top of what the timer holds by another reading. Where he wants nothing else and the timer
 * holds something else by now, it belongs to no setting any more: it may be another timer.
 * @param held what it held by the one before.
 */
export function ontoReading(content: Content, held: TimerProgram, read: TimerProgram): Content {
  const { working, texts, of, backupOf } = content;
  const edits = differences(held, working).flatMap(({ field, to }): FieldValue[] =>
    to === null ? [] : [{ field, value: to }],
  );
  const wanted = withValues(read, edits);
  // A text that says what the timer held before must not stand for what it holds now.
  const changed = differences(read, wanted).map(({ field }) => fieldKey(field));
  const stays = new Set([...unreadableIn({ working: wanted, texts }).keys(), ...changed]);
  const drops = Object.keys(texts).filter((key) => !stays.has(key));
  const isOther = edits.length === 0 && differences(held, read).length > 0;
  return { working: wanted, texts: without(texts, drops), ...(isOther ? {} : { of, backupOf }) };
}

/** Fields that nobody had touched follow the timer to what it holds now, and so do texts that say what it held. */
export function followed(content: Content, moved: readonly Change[], read: TimerProgram): Content {
  const { working, texts } = content;
  const untouched = moved.flatMap(({ field, from, to }): FieldValue[] =>
    to !== null && valueAt(working, field) === from ? [{ field, value: to }] : [],
  );
  const unreadable = unreadableIn({ working, texts });
  const said = untouched.map(({ field }) => fieldKey(field)).filter((key) => !unreadable.has(key));
  const { memory } = read;
  const idleThrottle = working.idleThrottle ?? read.idleThrottle;
  return {
    ...content,
    working: { ...withValues(working, untouched), memory, idleThrottle },
    texts: without(texts, said),
  };
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

/**
 * What has changed in a program since it was saved as a setting. An idle throttle that was not known then, or is not
 * now, is no change.
 */
export function changesSince(saved: TimerProgram, working: TimerProgram): Change[] {
  return differences(saved, working).filter(({ from, to }) => from !== null && to !== null);
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
