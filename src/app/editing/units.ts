/**
 * Converts between what a pilot types and the units of the rooms below: hundredths of a second and whole steps. It
 * works on the digits as text, so that 0.07 is 7 and never 7.000000000000001.
 */

import { locale } from './locale.js';

/**
 * Why a typed text is not a value: it is empty, no number, finer than a hundredth of a second,
 * not a whole number, or ambiguous.
 */
export type UnreadableReason = 'empty' | 'not-a-time' | 'too-fine' | 'not-a-whole-number' | 'ambiguous';

/** A minute in hundredths of a second. */
export const MINUTE = 6000;

export type Parsed = { readonly value: number } | { readonly unreadable: Exclude<UnreadableReason, 'ambiguous'> };

/** Nobody sees these: they come with a copied text. */
const UNSEEN = /[\u00ad\u061c\u200b\u200e\u200f\u2060\u2066\u2068\u2069\ufeff]/g;
/** The signs that keyboards and other programs have for a minus. */
const MINUS = /[\u2010-\u2013\u2212]/g;
/** The characters of ASCII as wide as a Chinese or Japanese one, and how far they are from the usual ones. */
const WIDE = /[\uff01-\uff5e]/g;
const FROM_WIDE = 0xfee0;

/**
 * A typed or copied number without spaces around it, with plain spaces inside, and with the plain minus sign, digits
 * and marks.
 */
export function plainDigits(text: string): string {
  // Nearly every text.
  if (!/[^ -~]/.test(text)) return text.trim();
  return text
    .replaceAll(UNSEEN, '')
    .replaceAll(/\p{Zs}/gu, ' ')
    .replaceAll(MINUS, '-')
    .replaceAll(WIDE, (wide) => String.fromCharCode(wide.charCodeAt(0) - FROM_WIDE))
    .trim();
}

/** The possible meanings of a text, in hundredths of a second. All different. */
export interface Ambiguous {
  readonly unreadable: 'ambiguous';
  /** First as minutes, or minutes and seconds, the likeliest first; last as seconds. */
  readonly either: readonly [minutes: number, ...more: number[], seconds: number];
}

/** A text that is not a value, a text that is one, or an ambiguous text. */
export type TypedText = Parsed | Ambiguous;

const TIME = /^(?:(\d{1,4})(?::(?=[0-5]?\d(?:[.,]|$))|[.,](?=[0-5]\d[.,])))?(\d{1,6})?(?:[.,](\d*))?$/;
const IN_UNITS = /^(?:(\d{1,4}) ?(?:min|хв))?(?: ?(\d*[.,]?\d*) ?(?:s|sec|с)?)?$/i;
const CLOCK_IN_MINUTES = /^(\d+:[\d.,]+) ?(?:min|хв)$/i;
/** Minutes and seconds as on a score card: `2'30`, `2′30″`, `2m30s`. */
const CARD = /^(\d{1,3}) ?['’′m] ?([0-5]\d(?:[.,]\d{1,2})?) ?(?:["”″s]|'')?$/i;
/** The same with a space. Where minutes are not usual, these may be two numbers. */
const SPACED = /^(\d{1,3}) ([0-5]\d(?:[.,]\d{1,2})?) ?(?:["”″s]|'')?$/i;
const DECIMAL_MINUTES = /^(\d{0,4})[.,](\d{1,2}) ?(?:min|хв)$/i;

/**
 * Reads a time in hundredths of a second. Forms: `12.5`, `12,5`, `.5`, `2:05`, `2:05.5`; `2.05.5`, because the number
 * pads of some phones have no colon; and with units `20 s`, `3 min`, `2.5 min`, `2 min 30 s`, `3:00 min`, `2'30`,
 * `2m30s`. A number without unit or colon is in seconds. {@link readTime} asks what a pilot may have meant.
 */
export function parseTime(text: string): Parsed {
  const trimmed = plainDigits(text);
  if (trimmed === '') return { unreadable: 'empty' };
  const match = TIME.exec(withoutUnits(trimmed));
  const [, minutes = '0', seconds = '', fraction = ''] = match ?? [];
  if (!match || (seconds === '' && fraction === '')) return { unreadable: 'not-a-time' };
  if (/[1-9]/.test(fraction.slice(2))) return { unreadable: 'too-fine' };
  return { value: Number(minutes) * MINUTE + Number(seconds) * 100 + Number(fraction.slice(0, 2).padEnd(2, '0')) };
}

/** The same time with a colon, or in plain seconds. A text of another form stays as it is. */
function withoutUnits(text: string): string {
  const clock = CLOCK_IN_MINUTES.exec(text)?.[1];
  if (clock !== undefined) return clock;
  const [, cardMinutes, cardSeconds] = CARD.exec(text) ?? [];
  if (cardMinutes !== undefined) return `${cardMinutes}:${cardSeconds}`;
  const [, whole, fraction = ''] = DECIMAL_MINUTES.exec(text) ?? [];
  if (whole !== undefined) return String(Number(whole) * 60 + (Number(fraction.padEnd(2, '0')) * 60) / 100);
  const [, minutes, seconds] = IN_UNITS.exec(text) ?? [];
  if (minutes === undefined) return seconds ?? text;
  return `${minutes}:${seconds || '00'}`;
}

/** The longest DT of the manuals (12 min), in hundredths of a second. */
const LONGEST_DT = 72_000;
const MINUTES_ALONE = /^(\d{1,2})[.,]?$/;
const MINUTES_POINT_SECONDS = /^(\d{0,2})[.,]([0-5]\d?)$/;
/** Half minutes, or decimals that cannot be seconds: so decimals of a minute. */
const MINUTES_POINT_DECIMALS = /^(\d{0,2})[.,](5|[6-9]\d?)$/;
const MINUTES_AND_SECONDS = /^(\d{1,2})([0-5]\d)$/;
/** Two digits after the point may be seconds also where the unit is said: `2.30 min`. */
const MINUTES_POINT_SECONDS_MIN = /^(\d{0,2})[.,]([0-5]\d) ?(?:min|хв)$/i;
/** How pilots write minutes without saying so, the likeliest first, and what the two digits after are worth. */
const FORMS: readonly (readonly [RegExp, number])[] = [
  [MINUTES_AND_SECONDS, 100],
  [MINUTES_POINT_SECONDS_MIN, 100],
];
const DT_FORMS: typeof FORMS = [
  ...FORMS,
  [MINUTES_POINT_DECIMALS, 60],
  [MINUTES_POINT_SECONDS, 100],
  [MINUTES_ALONE, 100],
];

/**
 * Like {@link parseTime}, but it asks where a pilot may also have meant minutes: the wrong guess would cost a flight or
 * a model. A text with a colon, a unit or two decimal marks is never ambiguous, but for `2.30 min`. These texts are:
 *
 * - everywhere, `230` and `0230`: 2 min 30 s or 230 s; and `2.30 min`: 2 min 30 s or 2.3 min, which is 138 s;
 * - for DT, which is set in minutes and whole seconds, also `2.30`, `2,30`, `.30`, and `2.3` for 2.30: 2 min 30 s or
 *   2.3 s;
 * - for DT also `2.5`: 2 min 30 s, 2 min 50 s or 2.5 s; and `2.75`: 2 min 45 s or 2.75 s;
 * - for DT also `3`: 3 min or 3 s.
 *
 * Minutes are possible up to the longest DT, 12 min. So `20` is 20 s, and `20.30` is 20.3 s. For DT `2 30` is 2 min
 * 30 s.
 */
export function readTime(text: string, { isDt }: { readonly isDt: boolean }): TypedText {
  const plain = plainDigits(text);
  const trimmed = isDt ? plain.replace(SPACED, '$1:$2') : plain;
  const parsed = parseTime(trimmed);
  if ('unreadable' in parsed) return parsed;
  const forms = isDt ? DT_FORMS : FORMS;
  const meant = forms.flatMap(([form, perHundredth]) => {
    const [, minutes, part = ''] = form.exec(trimmed) ?? [];
    return minutes === undefined ? [] : [Number(minutes) * MINUTE + Number(part.padEnd(2, '0')) * perHundredth];
  });
  const [first, ...more] = meant.filter((value) => value !== parsed.value && value <= LONGEST_DT);
  if (first === undefined) return parsed;
  return { unreadable: 'ambiguous', either: [first, ...more, parsed.value] };
}

const STEPS = /^(-?\d{1,6})(?: ?steps?)?$/i;

/** Reads `65` and `65 steps`. A minus sign is understood, so that the value can be refused with the right reason. */
export function parseSteps(text: string): Parsed {
  const trimmed = plainDigits(text);
  if (trimmed === '') return { unreadable: 'empty' };
  const [, steps] = STEPS.exec(trimmed) ?? [];
  return steps === undefined ? { unreadable: 'not-a-whole-number' } : { value: Number(steps) };
}

/**
 * Writes hundredths of a second as pilots do: `0.50`, `12.05`; from one minute on `3:00` or `3:00.50`; with a comma
 * where the language has one.
 */
export function formatTime(hundredths: number): string {
  if (!Number.isInteger(hundredths) || hundredths < 0) return String(hundredths);
  const fraction = String(hundredths % 100).padStart(2, '0');
  const seconds = Math.floor(hundredths / 100);
  const { decimal } = locale.value;
  if (seconds < 60) return `${seconds}${decimal}${fraction}`;
  const clock = `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, '0')}`;
  return fraction === '00' ? clock : `${clock}${decimal}${fraction}`;
}

/** Like {@link parseTime}, with a minus sign where times fall. */
export function parseInterval(text: string): Parsed {
  return signed(text, parseTime, (parsed) => ('value' in parsed ? { value: 0 - parsed.value } : parsed));
}

/** Like {@link readTime}, with a minus sign where times fall. */
export function readInterval(text: string, kind: { readonly isDt: boolean }): TypedText {
  return signed(
    text,
    (digits) => readTime(digits, kind),
    (read) => {
      if ('value' in read) return { value: 0 - read.value };
      if (!('either' in read)) return read;
      const [first, ...others] = read.either;
      const [seconds = 0, ...more] = others.map((value) => 0 - value).reverse();
      return { ...read, either: [0 - first, ...more.reverse(), seconds] };
    },
  );
}

function signed<T>(text: string, read: (digits: string) => T, negative: (read: T) => T): T {
  const [, sign, digits = text] = /^(-)(?=[\d.,])(.*)$/.exec(plainDigits(text)) ?? [];
  return sign ? negative(read(digits)) : read(digits);
}

/** Like {@link formatTime}, with a minus sign where times fall. */
export function formatInterval(hundredths: number): string {
  return hundredths < 0 ? `-${formatTime(-hundredths)}` : formatTime(hundredths);
}

/** A time as a large figure, with its unit. */
export interface Figure {
  readonly text: string;
  readonly unit: 's' | 'min';
}

/**
 * Seconds below one minute, minutes and seconds from then on: `10.0` s, `20` s, `3:00` min. It has as many decimals as
 * the step of the time, or more where the time has more.
 * @param step hundredths of a second.
 */
export function formatFigure(hundredths: number, step: number): Figure {
  const unit = hundredths < MINUTE ? 's' : 'min';
  const { decimal } = locale.value;
  const [whole = '', fraction = ''] = formatTime(hundredths).split(decimal);
  const needed = unit === 'min' || step % 100 === 0 ? 0 : step % 10 === 0 ? 1 : 2;
  const shown = fraction.replace(/0+$/, '').padEnd(needed, '0');
  return { text: shown === '' ? whole : `${whole}${decimal}${shown}`, unit };
}

/** The parts of a time for a spoken form: `2` and `30`, `0` and `2.3`. */
export function spokenParts(hundredths: number): { readonly minutes: number; readonly seconds: string } {
  return { minutes: Math.floor(hundredths / MINUTE), seconds: plainSeconds(hundredths % MINUTE) };
}

/** Seconds without needless zeros: `230`, `2.3`. */
export function plainSeconds(hundredths: number): string {
  return numberText(hundredths / 100);
}

/** A number as the language writes it: `2.3`, `2,3`. */
export function numberText(value: number): string {
  return String(value).replace('.', locale.value.decimal);
}
