import { type Flight, valueAt } from '../../program/index.js';
import { flightMessages } from '../messages/en-flights.js';
import { dayOf, offsetText, timeOfDay } from './flight-list.js';

/** How a country writes tables and numbers. Where numbers have a comma, semicolons stand between columns. */
export interface Marks {
  readonly separator: ';' | ',';
  readonly decimal: ',' | '.';
}

/** What is usual in a language, such as `de-AT`. Default: that of the browser. */
export function marksOf(language?: string): Marks {
  const hasComma = new Intl.NumberFormat(language).format(1.5).includes(',');
  return hasComma ? { separator: ';', decimal: ',' } : { separator: ',', decimal: '.' };
}

const { columns: HEADS } = flightMessages.csv;
export type CsvColumn = keyof typeof HEADS;
/** The columns of the file, in their order. */
export const CSV_COLUMNS = Object.keys(HEADS) as CsvColumn[];

/** Texts that a spreadsheet would calculate instead of showing. Some take the wide signs for the narrow ones. */
const FORMULA = /^(?:'|\s*[=+\-@＝＋－＠]|[\t\r\n])/;

/**
 * The flights as a table for spreadsheets (RFC 4180). UTF-8 with a mark at the start, so that Excel recognises it;
 * dates in ISO 8601, on the clock of the field. A text that looks like a formula gets an apostrophe before it, and so
 * does a text that begins with one: a reader removes one apostrophe.
 */
export function flightsCsv(flights: readonly Flight[], marks: Marks): string {
  const rows = [
    CSV_COLUMNS.map((column) => quoted(HEADS[column])),
    ...flights.map((flight) => CSV_COLUMNS.map((column) => cell(flight, column, marks))),
  ];
  return `\uFEFF${rows.map((row) => `${row.join(marks.separator)}\r\n`).join('')}`;
}

function cell(flight: Flight, column: CsvColumn, { decimal }: Marks): string {
  const number = (value: number | null): string => (value === null ? '' : String(value).replace('.', decimal));
  const seconds = (hundredths: number | null): string => number(hundredths === null ? null : hundredths / 100);
  const { identity, memory } = flight.program;
  switch (column) {
    case 'date':
      return dayOf(flight);
    case 'time':
      return timeOfDay(flight);
    case 'zone':
      return text(offsetText(flight));
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

/** A text is always in quotes: otherwise the other separator would begin a new cell. */
function text(value: string): string {
  return value === '' ? '' : quoted(FORMULA.test(value) ? `'${value}` : value);
}

function quoted(value: string): string {
  return `"${value.replaceAll('"', '""')}"`;
}
