/**
 * Between what a pilot types and what the rooms below count in: hundredths of a second and whole steps. Digits are
 * taken apart as text, so that 0.07 is 7 and never 7.000000000000001.
 */

/**
 * Why a typed text is not a value: nothing in it, no number, finer than a hundredth of a second, not a whole number, or
 * one that a pilot can mean in several ways.
 */
export type UnreadableReason = 'empty' | 'not-a-time' | 'too-fine' | 'not-a-whole-number' | 'ambiguous';

export type Parsed = { readonly value: number } | { readonly unreadable: Exclude<UnreadableReason, 'ambiguous'> };

/** What a text may mean, in hundredths of a second: never the same twice. */
export interface Ambiguous {
  readonly unreadable: 'ambiguous';
  /** As minutes, or minutes and seconds, the likeliest first; at the end as seconds. */
  readonly either: readonly [minutes: number, ...more: number[], seconds: number];
}

/** A text is not a value, or one, or asks which of several is meant. */
export type TypedText = Parsed | Ambiguous;

const TIME = /^(?:(\d{1,4})(?::(?=[0-5]?\d(?:[.,]|$))|[.,](?=[0-5]\d[.,])))?(\d{1,6})?(?:[.,](\d*))?$/;
const IN_UNITS = /^(?:(\d{1,4}) ?min)?(?: ?(\d*[.,]?\d*) ?s?)?$/i;
const CLOCK_IN_MINUTES = /^(\d+:[\d.,]+) ?min$/i;
const DECIMAL_MINUTES = /^(\d{0,4})[.,](\d{1,2}) ?min$/i;

/**
 * `12.5`, `12,5`, `.5`, `2:05`, `2:05.5` to hundredths of a second; `2.05.5` too, since the number pads of some phones
 * have no colon; and with units, `20 s`, `3 min`, `2.5 min`, `2 min 30 s`, `3:00 min`. Without units and colon it
 * is seconds: see {@link readTime} for what a pilot may have meant.
 */
export function parseTime(text: string): Parsed {
  const trimmed = text.trim();
  if (trimmed === '') return { unreadable: 'empty' };
  const match = TIME.exec(withoutUnits(trimmed));
  const [, minutes = '0', seconds = '', fraction = ''] = match ?? [];
  if (!match || (seconds === '' && fraction === '')) return { unreadable: 'not-a-time' };
  if (/[1-9]/.test(fraction.slice(2))) return { unreadable: 'too-fine' };
  return { value: Number(minutes) * 6000 + Number(seconds) * 100 + Number(fraction.slice(0, 2).padEnd(2, '0')) };
}

/** The same time with a colon, or in plain seconds; a text of another form as it is. */
function withoutUnits(text: string): string {
  const clock = CLOCK_IN_MINUTES.exec(text)?.[1];
  if (clock !== undefined) return clock;
  const [, whole, fraction = ''] = DECIMAL_MINUTES.exec(text) ?? [];
  if (whole !== undefined) return String(Number(whole) * 60 + (Number(fraction.padEnd(2, '0')) * 60) / 100);
  const [, minutes, seconds] = IN_UNITS.exec(text) ?? [];
  if (minutes === undefined) return seconds ?? text;
  return `${minutes}:${seconds || '00'}`;
}

/** No DT is longer by the manuals: so many minutes, in hundredths of a second. */
const LONGEST_DT = 72_000;
const MINUTES_ALONE = /^(\d{1,2})[.,]?$/;
const MINUTES_POINT_SECONDS = /^(\d{0,2})[.,]([0-5]\d?)$/;
/** Half a minute, or what can be no seconds: decimals of a minute, then. */
const MINUTES_POINT_DECIMALS = /^(\d{0,2})[.,](5|[6-9]\d?)$/;
const MINUTES_AND_SECONDS = /^(\d{1,2})([0-5]\d)$/;
/** How minutes are written without saying so, the likeliest first, and what one of the two digits after is worth. */
const FORMS: readonly (readonly [RegExp, number])[] = [[MINUTES_AND_SECONDS, 100]];
const DT_FORMS: typeof FORMS = [
  ...FORMS,
  [MINUTES_POINT_DECIMALS, 60],
  [MINUTES_POINT_SECONDS, 100],
  [MINUTES_ALONE, 100],
];

/**
 * Like {@link parseTime}, but where a pilot may as well have meant minutes it asks which: silently taking the wrong one
 * costs a flight or a model. With a colon, with units and with two marks a text is never in question. Else it is
 *
 * - everywhere, `230` and `0230`: 2 min 30 s or 230 s;
 * - for DT, which is set in minutes and whole seconds, also `2.30`, `2,30`, `.30`, and `2.3` for 2.30: 2 min 30 s or
 * 2.3 s;
 * - for DT also `2.5`: 2 min 30 s, 2 min 50 s or 2.5 s; and `2.75`: 2 min 45 s or 2.75 s;
 * - for DT also `3`: 3 min or 3 s.
 *
 * Minutes are in question up to the 12 of the longest DT: `20` is 20 s, and so is `20.30` no 20 minutes.
 */
export function readTime(text: string, { isDt }: { readonly isDt: boolean }): TypedText {
  const parsed = parseTime(text);
  if ('unreadable' in parsed) return parsed;
  const trimmed = text.trim();
  const forms = isDt ? DT_FORMS : FORMS;
  const meant = forms.flatMap(([form, perHundredth]) => {
    const [, minutes, part = ''] = form.exec(trimmed) ?? [];
    return minutes === undefined ? [] : [Number(minutes) * 6000 + Number(part.padEnd(2, '0')) * perHundredth];
  });
  const [first, ...more] = meant.filter((value) => value !== parsed.value && value <= LONGEST_DT);
  if (first === undefined) return parsed;
  return { unreadable: 'ambiguous', either: [first, ...more, parsed.value] };
}

/** `65` to 65. A sign is understood, so that the value can be refused for what it is. */
export function parseSteps(text: string): Parsed {
  const trimmed = text.trim();
  if (trimmed === '') return { unreadable: 'empty' };
  if (!/^-?\d{1,6}$/.test(trimmed)) return { unreadable: 'not-a-whole-number' };
  return { value: Number(trimmed) };
}

/** Hundredths of a second as a pilot writes them: `0.50`, `12.05`; from a minute on `3:00` or `3:00.50`. */
export function formatTime(hundredths: number): string {
  if (!Number.isInteger(hundredths) || hundredths < 0) return String(hundredths);
  const fraction = String(hundredths % 100).padStart(2, '0');
  const seconds = Math.floor(hundredths / 100);
  if (seconds < 60) return `${seconds}.${fraction}`;
  const clock = `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, '0')}`;
  return fraction === '00' ? clock : `${clock}.${fraction}`;
}

/** Like {@link parseTime}, with a minus sign before it where times fall. */
export function parseInterval(text: string): Parsed {
  return signed(text, parseTime, (parsed) => ('value' in parsed ? { value: 0 - parsed.value } : parsed));
}

/** Like {@link readTime}, with a minus sign before it where times fall. */
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
  const [, sign, digits = text] = /^([-−])(?=[\d.,])(.*)$/.exec(text.trim()) ?? [];
  return sign ? negative(read(digits)) : read(digits);
}

/** Like {@link formatTime}, with a minus sign before it where times fall. */
export function formatInterval(hundredths: number): string {
  return hundredths < 0 ? `-${formatTime(-hundredths)}` : formatTime(hundredths);
}

/** A time as a large figure, and what its unit is. */
export interface Figure {
  readonly text: string;
  readonly unit: 's' | 'min';
}

/**
 * Below a minute seconds, from a minute on minutes and seconds: `10.0` s, `20` s, `3:00` min. It has the decimals of
 * the step in which the time is set, and more where the time has them.
 * @param step hundredths of a second.
 */
export function formatFigure(hundredths: number, step: number): Figure {
  const unit = hundredths < 6000 ? 's' : 'min';
  const [whole = '', fraction = ''] = formatTime(hundredths).split('.');
  const needed = unit === 'min' || step % 100 === 0 ? 0 : step % 10 === 0 ? 1 : 2;
  const shown = fraction.replace(/0+$/, '').padEnd(needed, '0');
  return { text: shown === '' ? whole : `${whole}.${shown}`, unit };
}

/** A time taken apart to be said: `2` and `30`, `0` and `2.3`. */
export function spokenParts(hundredths: number): { readonly minutes: number; readonly seconds: string } {
  return { minutes: Math.floor(hundredths / 6000), seconds: plainSeconds(hundredths % 6000) };
}

/** Seconds without a zero too many: `230`, `2.3`. */
export function plainSeconds(hundredths: number): string {
  return String(hundredths / 100);
}
