import type { Flight, TimerProgram } from '../../program/index.js';
import { foldedOf, searchFor } from '../messages/search.js';
import { askCalendar } from '../messages/today.js';
import type { FlightRecord } from '../storage/index.js';
import type { FlightFilter } from './flight-filter.js';

export interface Totals {
  readonly flights: number;
  /** Seconds; null when fewer than two flights have a result. */
  readonly best: number | null;
  readonly average: number | null;
}

/** When a flight was: a moment, and the clock of its field. */
export type When = Pick<Flight, 'at' | 'utcOffset'>;

/** The flights that pass the filter, in the same order. */
export function filtered(records: readonly FlightRecord[], { of, text, day }: FlightFilter): readonly FlightRecord[] {
  const isFound = searchFor(text);
  return records.filter((record) => {
    const { flight } = record;
    if (of && flight[of.kind] !== of.id) return false;
    if (day !== null && dayKey(flight) !== day) return false;
    return text === '' || isFound(textOf(record));
  });
}

/** The same flights by day and place, in the given order (newest first). Each place of a day comes once. */
export function grouped(records: readonly FlightRecord[]): ReadonlyMap<string, readonly FlightRecord[]> {
  const days = new Map<string, FlightRecord[]>();
  for (const record of records) {
    const key = dayKey(record.flight);
    const day = days.get(key);
    if (day) day.push(record);
    else days.set(key, [record]);
  }
  return days;
}

function dayKey(flight: Flight): string {
  return `${dayOf(flight)} ${flight.place}`;
}

/** What the model of a flight flew before it, by the key of the flight. Of a flight without a model nobody knows. */
export function flownBefore(records: readonly FlightRecord[]): ReadonlyMap<string, TimerProgram> {
  const before = new Map<string, TimerProgram>();
  const later = new Map<string, string>();
  for (const { key, flight } of records) {
    if (flight.model === null) continue;
    const next = later.get(flight.model);
    if (next !== undefined) before.set(next, flight.program);
    later.set(flight.model, key);
  }
  return before;
}

export function totalsOf(records: readonly FlightRecord[]): Totals {
  const results = records.flatMap(({ flight }) => flight.result ?? []);
  // Of a single result, best and average would be that result.
  if (results.length < 2) return { flights: records.length, best: null, average: null };
  const sum = results.reduce((one, other) => one + other);
  // Rounded down: an average of 179.7 s is no 3:00 min, and is never above the best. A sum of tenths has an error.
  const average = Math.floor((sum / results.length) * 10 + 1e-6) / 10;
  return { flights: records.length, best: results.reduce((one, other) => Math.max(one, other)), average };
}

/** The number of a round such as “3”, “3.” or “3/5”; null for one with letters, such as a fly-off, and for none. */
export function roundNumber(round: string): number | null {
  const [number] = /^\d+(?!.*\p{L})/u.exec(round.trim()) ?? [];
  return number === undefined ? null : Number(number);
}

/** The round after one: “4” after “3”, “fly-off 2” after “fly-off 1”. Empty after one without a number. */
export function nextRound(round: string): string {
  const [, name, number] = /^(.*?)(\d{1,3})$/.exec(round.trim()) ?? [];
  return number === undefined ? '' : `${name}${Number(number) + 1}`;
}

/** The places in the log, the latest first. */
export function placesOf(records: readonly FlightRecord[]): readonly string[] {
  return [...new Set(records.map(({ flight }) => flight.place))].filter((place) => place !== '');
}

/** A calendar day on the clock of the field, in the form of files and fields: `2026-11-22`. */
export function dayOf(when: When): string {
  return onClock(when).toISOString().slice(0, 10);
}

/** A time of day on the clock of the field: `14:05`. */
export function timeOfDay(when: When): string {
  return onClock(when).toISOString().slice(11, 16);
}

/** What the clock of the field showed, as the UTC of a date. Where that is not known: what this device would show. */
export function onClock({ at, utcOffset = deviceOffset(at) }: When): Date {
  askCalendar();
  return new Date(at + utcOffset * 60_000);
}

/** The moment at which the clock of a flight shows a day and a time; NaN when the text is none. */
export function momentOf(text: string, { utcOffset }: Partial<When>): number {
  const shown = new Date(utcOffset === undefined ? text : `${text}Z`).getTime();
  return shown - (utcOffset ?? 0) * 60_000;
}

/** How far the clock of this device is ahead of UTC at a moment, in minutes. */
export function deviceOffset(at: number): number {
  return 0 - new Date(at).getTimezoneOffset();
}

/** “UTC+08:00”; empty when it is not known. */
export function offsetText({ utcOffset }: Partial<When>): string {
  if (utcOffset === undefined) return '';
  const size = new Date(Math.abs(utcOffset) * 60_000).toISOString().slice(11, 16);
  return `UTC${utcOffset < 0 ? '−' : '+'}${size}`;
}

/** What the search looks through: the pilot's words, and the date. */
const textOf = foldedOf<FlightRecord>(({ flight }) => {
  const { place, modelName, settingName, round, note } = flight;
  return [dayOf(flight), place, modelName, settingName, round, note];
});
