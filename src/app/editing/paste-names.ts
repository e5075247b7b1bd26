/**
 * Recognises what the rows and columns of a pasted table are called: in the words of the page, in its language and in
 * English, and in the short forms that pilots use. A test holds that the page's own words are among them.
 */

import { computed } from '@preact/signals';
import type { Identity } from '../../protocol/index.js';
import { FIRST_SERVO_COLUMN, INTERVAL_COLUMN, TIME_COLUMN } from './grid.js';
import { locale } from './locale.js';
import { plainDigits } from './units.js';

/**
 * Where a row belongs: to a slot, which the program need not have; to the motor stop; to nothing that is wanted; or it
 * is not known.
 */
export type RowPlace = { readonly slot: number } | 'motor' | 'none' | 'unknown';

/**
 * Where a column belongs: to a column of the grid, which the program need not have; it holds the names of the rows; it
 * is not wanted; or it is not known.
 */
export type ColumnPlace = { readonly column: number; readonly inMinutes: boolean } | 'names' | 'none' | 'unknown';

const SECONDS = /^(?:|s|sec|secs|seconds?)$/;
const MINUTES = /^(?:min|mins|minutes?|m:ss?|mm:ss|min:s{1,2})$/;
const STEPS = /^(?:|steps?|units?)$/;
const TIME = /^(?:times?|t)$/;
const INTERVAL = /^(?:after|intervals?|[δ∆] ?t?|delta ?t?)$/;
/** “S1”, “Servo 1”, and with what it moves: “S1 Rudder”. */
const SERVO = /^s(?:ervo)?\.? ?#?0?([1-9]\d?)(?: ?\p{L}[\p{L} -]*)?$/u;
const NAMES = /^(?:functions?|func|fn|f|slot)$/;

const START = /^(?:start|launch)$/;
const MOTOR_STOP = /^(?:motor|motor ?stop|motor ?off)$/;
const DT = /^(?:dt|d\/t|dethermali[sz]er)$/;
const FUNCTION = /^(?:(?:functions?|func|fn|f)\.? ?#?0?|(?=\d+\. function$))([1-9]\d?)(?:\. function)?$/;
const NUMBER = /^0?([1-9]\d?)$/;

/** “Time (s)”, “Time [s]”, “Time / s”, “Time, s”. */
const UNIT_APART = /^(.*?) ?(?:\(([^()]*)\)|\[([^[\]]*)\]|[/,] ?([^/,]*))$/;
/** “Time s”, as the page has it. */
const UNIT_BESIDE = /^(.+) (s|sec|min|steps)\.?$/;

/** A name in plain small letters, without what nobody sees and without a mark at its end. */
export function bareName(text: string): string {
  const name = plainDigits(text.normalize('NFKC'))
    .toLowerCase()
    .replaceAll(/\s+/g, ' ')
    .replace(/ ?[.:]$/, '');
  const { form, known } = ownWords.value;
  return known.size === 0 ? name : name.replaceAll(form, (word) => known.get(word) ?? word);
}

/** The language's words that are not English. A short one may be part of a long one. Hungarian has “3. function”. */
const ownWords = computed(() => {
  const words = locale.value.words.filter(([own, known]) => own !== known);
  const longestFirst = words
    .map(([own]) => own.replaceAll(/[.*+?^${}()|[\]\\/]/g, '\\$&'))
    .sort((a, b) => b.length - a.length);
  return { form: new RegExp(`(?<!\\p{L})(?:${longestFirst.join('|')})(?!\\p{L})`, 'gu'), known: new Map(words) };
});

function unitOf(name: string): { readonly head: string; readonly unit: string } {
  const [, head = '', ...apart] = UNIT_APART.exec(name) ?? [];
  const unit = apart.find((each) => each !== undefined);
  if (unit !== undefined && head !== '' && name !== 'd/t') return { head, unit: unit.trim().replace(/\.$/, '') };
  const [, beside = name, short = ''] = UNIT_BESIDE.exec(name) ?? [];
  return { head: beside, unit: short };
}

/** The column that a heading names. With an unknown unit it is not known. */
export function columnNamed(text: string): ColumnPlace {
  const name = bareName(text);
  if (NAMES.test(name)) return 'names';
  const { head, unit } = unitOf(name);
  const timed = TIME.test(head) ? TIME_COLUMN : INTERVAL.test(head) ? INTERVAL_COLUMN : null;
  if (timed !== null) {
    const inMinutes = MINUTES.test(unit);
    return inMinutes || SECONDS.test(unit) ? { column: timed, inMinutes } : 'unknown';
  }
  const servo = Number(SERVO.exec(head)?.[1]);
  if (Number.isNaN(servo) || !STEPS.test(unit)) return 'unknown';
  return { column: FIRST_SERVO_COLUMN + servo - 1, inMinutes: false };
}

/** Whether a heading names a column of values. */
export function isColumnName(text: string): boolean {
  return typeof columnNamed(text) === 'object';
}

/**
 * The row that a name names.
 * @param numbered whether a number alone is the number of a function.
 */
export function rowNamed({ functions }: Identity, text: string, numbered: boolean): RowPlace {
  const name = bareName(text);
  const { head } = name === 'd/t' ? { head: name } : unitOf(name);
  if (START.test(head)) return { slot: 0 };
  if (MOTOR_STOP.test(head)) return 'motor';
  if (DT.test(head)) return { slot: functions };
  const number = Number((FUNCTION.exec(head) ?? (numbered ? NUMBER.exec(head) : null))?.[1]);
  if (Number.isNaN(number)) return 'unknown';
  // The last slot is DT: a function with its number would be one too many.
  return { slot: number < functions ? number : Number.POSITIVE_INFINITY };
}

/** Whether a row's name says that its times are minutes: “DT min”. */
export function isInMinutes(text: string): boolean {
  return MINUTES.test(unitOf(bareName(text)).unit);
}

/** A unit that stands alone, without its brackets and its point. */
function unitAlone(text: string): string {
  return bareName(text)
    .replace(/^[([](.*)[)\]]$/, '$1')
    .replace(/\.$/, '');
}

/** Whether a text is nothing but a unit. */
export function isUnit(text: string): boolean {
  const unit = unitAlone(text);
  return unit !== '' && [SECONDS, MINUTES, STEPS].some((form) => form.test(unit));
}

/** Whether such a unit is minutes. */
export function isMinutes(text: string): boolean {
  return MINUTES.test(unitAlone(text));
}

/** Also “3. funkció”, as Hungarian has it. */
const WORD = /^(?:\d{1,2}\. )?(?!(?:nan|inf|infinity|err\s?:\d+)$)\p{L}/iu;

/**
 * Whether these are headings or names: there are some, and each begins with a word.
 * The error texts of spreadsheets do not count.
 */
export function areWords(texts: readonly string[]): boolean {
  const some = texts.filter((text) => text !== '');
  return some.length > 0 && some.every((text) => WORD.test(text));
}
