import type { Flight } from '../../program/index.js';
import { nameplate } from '../browser/services.js';
import { language } from '../messages/language.js';
import { moreMessages } from '../messages/more.js';
import type { MoreSentences } from '../messages/sentences.js';
import { dayOf, offsetText, timeOfDay } from './flight-list.js';

/** How a country writes tables and numbers. Where numbers have a comma, semicolons stand between columns. */
export interface Marks {
  readonly separator: ';' | ',';
  readonly decimal: ',' | '.';
}

/** What is usual in a language, such as `de`. Default: that of the page. As in its country, if the browser says one. */
export function marksOf(spoken = language.value): Marks {
  const local = nameplate().languages.find((each) => each.toLowerCase().replace(/-.*/, '') === spoken);
  const hasComma = new Intl.NumberFormat(local ?? spoken).format(1.5).includes(',');
  return hasComma ? { separator: ';', decimal: ',' } : { separator: ',', decimal: '.' };
}

export type CsvColumn = keyof MoreSentences['flights']['csv']['columns'];
/** The columns of the file, in their order. */
export function csvColumns(): readonly CsvColumn[] {
  return Object.keys(moreMessages.value.flights.csv.columns) as CsvColumn[];
}

/** Texts that a spreadsheet would calculate instead of showing. Some take the wide signs for the narrow ones. */
const FORMULA = /^(?:'|\s*[=+\-@＝＋－＠]|[\t\r\n])/;

/**
 * The flights as a table for spreadsheets (RFC 4180). UTF-8 with a mark at the start, so that Excel recognises it;
 * dates in ISO 8601, on the clock of the field. A text that looks like a formula gets an apostrophe before it, and so
 * does a text that begins with one: a reader removes one apostrophe.
 */
export function flightsCsv(flights: readonly Flight[], marks: Marks): string {
  const { columns: heads } = moreMessages.value.flights.csv;
  const columns = csvColumns();
  const rows = [
    columns.map((column) => quoted(heads[column])),
    ...flights.map((flight) => {
      const cells = cellsOf(flight, marks);
      return columns.map((column) => cells[column]);
    }),
  ];
  return `\uFEFF${rows.map((row) => `${row.join(marks.separator)}\r\n`).join('')}`;
}

function cellsOf(flight: Flight, { decimal }: Marks): Readonly<Record<CsvColumn, string>> {
  const number = (value: number | null): string => (value === null ? '' : String(value).replace('.', decimal));
  const { identity, memory, times } = flight.program;
  const seconds = (slot: number): string => number((times[slot] as number) / 100);
  return {
    date: dayOf(flight),
    time: timeOfDay(flight),
    zone: text(offsetText(flight)),
    place: text(flight.place),
    model: text(flight.modelName),
    setting: text(flight.settingName),
    timerClass: text(identity.timerClass),
    memory: memory === null ? '' : String(memory + 1),
    dt: seconds(identity.functions),
    motorStop: identity.timerClass === 'Q' ? seconds(0) : '',
    wind: number(flight.wind),
    temperature: number(flight.temperature),
    round: text(flight.round),
    result: number(flight.result),
    maximum: number(flight.maximum ?? null),
    note: text(flight.note),
  };
}

/** A text is always in quotes: otherwise the other separator would begin a new cell. */
function text(value: string): string {
  return value === '' ? '' : quoted(noFormula(value));
}

export function noFormula(value: string): string {
  return FORMULA.test(value) ? `'${value}` : value;
}

function quoted(value: string): string {
  return `"${value.replaceAll('"', '""')}"`;
}
