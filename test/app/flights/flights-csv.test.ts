import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type CsvColumn, csvColumns, flightsCsv, marksOf } from '../../../src/app/flights/flights-csv.js';
import { moreMessages } from '../../../src/app/messages/more.js';
import { meant, readCsv } from './csv-reader.js';
import { anyFlight, PLAIN, recordOf } from './flights.js';

/** The columns in which a pilot's words stand. */
const WORDS = ['place', 'model', 'setting', 'round', 'note'] as const;
const { columns: heads } = moreMessages.value.flights.csv;

describe('the table of flights', () => {
  it('is read back by an independent reader, for every flight and with both separators', () => {
    fc.assert(
      fc.property(fc.array(anyFlight, { maxLength: 8 }), fc.constantFrom('de', 'en'), (flights, language) => {
        const marks = marksOf(language);
        const csv = flightsCsv(flights, marks);
        expect(csv.startsWith('\uFEFF')).toBe(true);
        const [head, ...rows] = readCsv(csv.slice(1), marks.separator);
        expect(head).toEqual(csvColumns().map((column) => heads[column]));
        expect(rows.length).toBe(flights.length);
        flights.forEach((flight, at) => {
          const cells = Object.fromEntries(
            csvColumns().map((column, index) => [column, rows[at]?.[index] ?? '']),
          ) as Record<CsvColumn, string>;
          const number = (text = ''): number | null => (text === '' ? null : Number(text.replace(marks.decimal, '.')));
          const [year = 0, month = 0, day = 0, hour = 0, minute = 0] = `${cells.date}-${cells.time}`
            .split(/[-:]/)
            .map(Number);
          expect(new Date(year, month - 1, day, hour, minute).getTime()).toBe(flight.at - (flight.at % 60_000));
          expect(WORDS.map((name) => meant(cells[name]))).toEqual([
            flight.place,
            flight.modelName,
            flight.settingName,
            flight.round,
            flight.note,
          ]);
          expect([cells.wind, cells.temperature, cells.result].map(number)).toEqual([
            flight.wind,
            flight.temperature,
            flight.result,
          ]);
          expect([cells.timerClass, cells.memory, cells.dt, cells.motorStop]).toEqual(['Q', '1', '180', '10']);
          // No cell of the pilot's words is worked out by a spreadsheet.
          for (const name of WORDS) {
            expect(cells[name]).not.toMatch(/^\s*[=+\-@＝＋－＠]|^[\t\r\n]/);
          }
        });
      }),
    );
  });

  it('has units in its head, numbers with a comma, and a minus that stays part of a number', () => {
    const flight = {
      ...PLAIN,
      at: Date.UTC(2026, 10, 22, 13, 5),
      utcOffset: 60,
      temperature: -2.5,
      wind: 3.5,
      result: 178.25,
      maximum: 180.5,
      note: '=HYPERLINK("x")',
    };
    const [head, row] = flightsCsv([flight], marksOf('de')).split('\r\n');
    expect(head).toBe(
      '\uFEFF"Date";"Time";"Time zone";"Place";"Model";"Program";"Timer class";"Memory";"DT (s)";"Motor stop (s)";"Wind (m/s)";"Temperature (°C)";"Round";"Result (s)";"Maximum (s)";"Note"',
    );
    expect(row).toBe(`2026-11-22;14:05;"UTC+01:00";;;;"Q";1;180;10;3,5;-2,5;;178,25;180,5;"'=HYPERLINK(""x"")"`);
  });

  it('has no motor stop for a class without a motor, and no memory where none is known', () => {
    const { program } = PLAIN;
    const flight = {
      ...PLAIN,
      program: { ...program, memory: null, identity: { ...program.identity, timerClass: 'B' } },
    };
    const [, row] = flightsCsv([recordOf(flight).flight], marksOf('en')).split('\r\n');
    expect(row).toBe('2026-11-22,14:05,,,,,"B",,180,,,,,,,');
  });

  it.each([
    ['en-GB', ',', '.'],
    ['en-US', ',', '.'],
    ['ja', ',', '.'],
    ['de-CH', ',', '.'],
    ['de-AT', ';', ','],
    ['hu', ';', ','],
    ['fr', ';', ','],
    ['sr-Latn', ';', ','],
  ])('in %s has “%s” between columns and “%s” in numbers', (language, separator, decimal) => {
    expect(marksOf(language)).toEqual({ separator, decimal });
  });
});
