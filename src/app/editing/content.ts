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
import { type EditValues, type FieldValue, type Owner, stepSize, withValues } from './edit.js';
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
 * What the pilot wants, and the texts in the fields as they were typed. An edit changes it, and undo brings it back.
 */
export interface Content extends Owner {
  readonly working: TimerProgram;
  readonly texts: Readonly<Record<string, string>>;
}

/** A field with a text that is not a value. */
export interface UnreadableField {
  readonly field: ProgramField;
  readonly reason: UnreadableReason;
  /** The possible meanings of an ambiguous text. */
  readonly either?: Ambiguous['either'] | undefined;
}

/** The value that a text has in a field. */
export function parseValue({ functions }: Identity, field: ProgramField, text: string): TypedText {
  return field.kind === 'time' ? readTime(text, { isDt: field.slot === functions }) : parseSteps(text);
}

/**
 * Writes a value in the form in which a pilot reads and types it. The motor stop has the form of the large figure,
 * `10.0`. A DT does not: `12` without a unit may be 12 s or 12 min.
 */
export function formatValue(identity: Identity, field: ProgramField, value: number): string {
  if (field.kind !== 'time') return String(value);
  const isMotorStop = field.slot === 0 && identity.timerClass === 'Q';
  return isMotorStop ? figureOfTime(identity, 0, value).text : formatTime(value);
}

/** A time as a large figure, with as many decimals as the step in which it is set. */
export function figureOfTime(identity: Identity, slot: number, value: number): Figure {
  const isDt = slot === identity.functions;
  return formatFigure(value, isDt ? 100 : stepSize(identity, { kind: 'time', slot }));
}

/** The texts that are not values, in the order of the fields. */
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

/** Whether two contents mean the same in every field. A text that is a value counts as that value. */
export function meansSame(a: Content, b: Content): boolean {
  const unreadable = (content: Content): string =>
    JSON.stringify([...unreadableIn(content).keys()].map((key) => [key, content.texts[key]]));
  return a.of?.id === b.of?.id && differences(a.working, b.working).length === 0 && unreadable(a) === unreadable(b);
}

/**
 * The value of a typed text; null when it has none. An ambiguous text has none, and the field goes back to its value
 * from before.
 * @param before the program before anything was typed there: before `230`, the text was `23` for a moment.
 */
export function valueOfText(field: ProgramField, text: string, before: TimerProgram): number | null {
  const parsed = parseValue(before.identity, field, text);
  if ('value' in parsed) return parsed.value;
  return 'either' in parsed ? valueAt(before, field) : null;
}

/** The first field whose text is not a value and that an edit would change unseen. */
export function inTheWay(unreadable: ReadonlyMap<string, unknown>, edit: EditValues): ProgramField | null {
  const { texts = {} } = edit;
  const isHidden = (key: string): boolean => unreadable.has(key) && !Object.hasOwn(texts, key);
  return edit.values.find(({ field }) => isHidden(fieldKey(field)))?.field ?? null;
}

/** Applies an edit. Gives the same objects where nothing changes. */
export function applied({ working, texts, of, backupOf }: Content, edit: EditValues): Content {
  const changes = edit.values.filter(({ field, value }) => valueAt(working, field) !== value);
  const replaced = edit.texts ?? {};
  const left = without(texts, [...edit.values.map(({ field }) => fieldKey(field)), ...Object.keys(replaced)]);
  const typed = Object.entries(replaced).filter((entry): entry is [string, string] => entry[1] !== null);
  return {
    working: withValues(working, changes),
    texts: typed.length > 0 ? { ...left, ...Object.fromEntries(typed) } : left,
    ...(edit.owner ?? { of, backupOf }),
  };
}

/** The owner of some content. */
export function ownerOf({ of, backupOf }: Content): Owner {
  return { of, backupOf };
}

/** Whether each field stands as in this program, and no text is in the way. */
export function isJust(content: Content, program: TimerProgram): boolean {
  return differences(program, content.working).length === 0 && unreadableIn(content).size === 0;
}

/**
 * Moves the pilot's wishes onto a new reading of the timer. If he has changed nothing and the timer now holds something
 * else, the program no longer belongs to a setting: it may be another timer.
 * @param held what the timer held in the reading before.
 */
export function ontoReading(content: Content, held: TimerProgram, read: TimerProgram): Content {
  const { working, texts, of, backupOf } = content;
  const edits = differences(held, working).flatMap(({ field, to }): FieldValue[] =>
    to === null ? [] : [{ field, value: to }],
  );
  const wanted = withValues(read, edits);
  // A text that matches the earlier reading must not stand for the new one.
  const changed = differences(read, wanted).map(({ field }) => fieldKey(field));
  const stays = new Set([...unreadableIn({ working: wanted, texts }).keys(), ...changed]);
  const drops = Object.keys(texts).filter((key) => !stays.has(key));
  const isOther = edits.length === 0 && differences(held, read).length > 0;
  return { working: wanted, texts: without(texts, drops), ...(isOther ? {} : { of, backupOf }) };
}

/**
 * Takes over the timer's new values for fields that nobody has touched, and for texts that only repeat its old values.
 */
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

/** Conflicts by field after another reading. `from` stays the value that the timer held when the edits were made. */
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
 * What has changed in a program since it was saved as a setting.
 * An idle throttle that was or is unknown does not count.
 */
export function changesSince(saved: TimerProgram, working: TimerProgram): Change[] {
  return differences(saved, working).filter(({ from, to }) => from !== null && to !== null);
}

/** The texts of fields that this program has. Others, which a file may contain, are dropped. */
export function textsFor({ identity }: TimerProgram, texts: Content['texts']): Content['texts'] {
  const keys = fieldsOf(identity).map(fieldKey);
  return Object.fromEntries(keys.filter((key) => Object.hasOwn(texts, key)).map((key) => [key, texts[key] as string]));
}

/** The texts without those of some fields. The same object when there were none. */
export function without(texts: Content['texts'], keys: readonly string[]): Content['texts'] {
  if (!keys.some((key) => Object.hasOwn(texts, key))) return texts;
  const dropped = new Set(keys);
  return Object.fromEntries(Object.entries(texts).filter(([key]) => !dropped.has(key)));
}
