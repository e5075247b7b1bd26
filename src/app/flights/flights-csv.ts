import { type Flight, valueAt } from '../../program/index.js';
import { dayOf, timeOfDay } from './flight-list.js';

/** Between the columns. Spreadsheets expect the one that is usual in their country. */
export const SEPARATORS = [';', ','] as const;
export type Separator = (typeof SEPARATORS)[number];

/** The columns of the file, in their order. */
export const CSV_COLUMNS = [
  'date',
  'time',
  'place',
  'model',
  'setting',
  'timerClass',
  'memory',
  'dt',
  'motorStop',
  'wind',
  'temperature',
  'round',
  'result',
  'note',
] as const;
export type CsvColumn = (typeof CSV_COLUMNS)[number];

/** Texts that a spreadsheet would calculate instead of showing. Some take the wide signs for the narrow ones. */
const FORMULA = /^(?:'|\s*[=+\-@＝＋－＠]|[\t\r\n])/;

/**
 * The flights as a table for spreadsheets (RFC 4180). UTF-8 with a mark at the start, so that Excel recognises it;
 * dates in ISO 8601; numbers with a point. A text that looks like a formula gets an apostrophe before it, and so does a
 * text that begins with one: a reader removes one apostrophe.
 * @param heads the names of the columns, with their units.
 */
export function flightsCsv(
  flights: readonly Flight[],
  { separator, heads }: { readonly separator: Separator; readonly heads: Readonly<Record<CsvColumn, string>> },
): string {
  const rows = [
    CSV_COLUMNS.map((column) => quoted(heads[column])),
    ...flights.map((flight) => CSV_COLUMNS.map((column) => cell(flight, column))),
  ];
  return `\uFEFF${rows.map((row) => `${row.join(separator)}\r\n`).join('')}`;
}

function cell(flight: Flight, column: CsvColumn): string {
  const { identity, memory } = flight.program;
  switch (column) {
    case 'date':
      return dayOf(flight.at);
    case 'time':
      return timeOfDay(flight.at);
    case 'place':
      return text(flight.place);
    case 'model':
      return text(flight.modelName);
    case 'setting':
      return text(flight.settingName);
    case 'timerClass':
      return text(identity.timerClass);
    case 'memory':
      return memory === null ? '' : String(memory + 1);
    case 'dt':
      return seconds(valueAt(flight.program, { kind: 'time', slot: identity.functions }));
    case 'motorStop':
      return identity.timerClass === 'Q' ? seconds(valueAt(flight.program, { kind: 'time', slot: 0 })) : '';
    case 'round':
    case 'note':
      return text(flight[column]);
    default:
      return number(flight[column]);
  }
}

function number(value: number | null): string {
  return value === null ? '' : String(value);
}

function seconds(hundredths: number | null): string {
  return hundredths === null ? '' : String(hundredths / 100);
}

/** A text is always in quotes: otherwise the other separator would begin a new cell. */
function text(value: string): string {
  return value === '' ? '' : quoted(FORMULA.test(value) ? `'${value}` : value);
}

function quoted(value: string): string {
  return `"${value.replaceAll('"', '""')}"`;
}
