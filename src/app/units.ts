/**
 * Between what a pilot types and what the rooms below count in: hundredths of a second and whole steps. Digits are taken apart as
 * text, so that 0.07 is 7 and never 7.000000000000001.
 */

/** Why a typed text is no value: nothing in it, no number, finer than a hundredth of a second, or not a whole number. */
export type UnreadableReason = 'empty' | 'not-a-time' | 'too-fine' | 'not-a-whole-number';

export type Parsed = { readonly value: number } | { readonly unreadable: UnreadableReason };

const TIME = /^(?:(\d{1,4})(?::(?=[0-5]?\d(?:[.,]|$))|[.,](?=[0-5]\d[.,])))?(\d{1,6})?(?:[.,](\d*))?$/;

/**
 * `12.5`, `12,5`, `.5`, `2:05`, `2:05.5` to hundredths of a second; `2.05.5` too, since the number pads of some phones have no
 * colon.
 */
export function parseTime(text: string): Parsed {
  const trimmed = text.trim();
  if (trimmed === '') return { unreadable: 'empty' };
  const match = TIME.exec(trimmed);
  const [, minutes = '0', seconds = '', fraction = ''] = match ?? [];
  if (!match || (seconds === '' && fraction === '')) return { unreadable: 'not-a-time' };
  if (/[1-9]/.test(fraction.slice(2))) return { unreadable: 'too-fine' };
  return { value: Number(minutes) * 6000 + Number(seconds) * 100 + Number(fraction.slice(0, 2).padEnd(2, '0')) };
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
  const [, sign, digits = text] = /^([-−])(?=[\d.,])(.*)$/.exec(text.trim()) ?? [];
  const parsed = parseTime(digits);
  return sign && 'value' in parsed ? { value: 0 - parsed.value } : parsed;
}

/** Like {@link formatTime}, with a minus sign before it where times fall. */
export function formatInterval(hundredths: number): string {
  return hundredths < 0 ? `-${formatTime(-hundredths)}` : formatTime(hundredths);
}
