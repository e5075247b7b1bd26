import fc from 'fast-check';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { type FlightFilter, NO_FILTER } from '../../../src/app/flights/flight-filter.js';
import {
  dayOf,
  deviceOffset,
  filtered,
  flownBefore,
  grouped,
  momentOf,
  offsetText,
  placesOf,
  timeOfDay,
  totalsOf,
} from '../../../src/app/flights/flight-list.js';
import { changedText, clockOf, dayHeading } from '../../../src/app/flights/flight-text.js';
import { withValue } from '../../../src/program/index.js';
import { programOf } from '../programs.js';
import { anyLog, PLAIN, recordOf } from './flights.js';

const anyFilter: fc.Arbitrary<FlightFilter> = fc.record({
  of: fc.constantFrom(null, ...(['lancer', 'gone'] as const).map((id) => ({ kind: 'model', id, name: '' }) as const), {
    kind: 'setting',
    id: 'calm',
    name: '',
  } as const),
  text: fc.constantFrom('', 'a', 'gyu 1', 'É', '2026-01-1'),
  day: fc.constantFrom(null, '2026-01-10 Wiese', '2026-01-11 '),
});

describe('the filter of the log', () => {
  it('shows exactly the flights that fit every part of it, in their order', () => {
    fc.assert(
      fc.property(anyLog, anyFilter, (log, filter) => {
        const parts = Object.entries(filter).map(([name, value]) => ({ [name]: value }));
        // One part at a time, in any order, is the same.
        const inTurn = parts.reduceRight<ReturnType<typeof filtered>>(
          (left, part) => filtered(left, { ...NO_FILTER, ...part }),
          log,
        );
        expect(filtered(log, filter)).toEqual(inTurn);
        expect(inTurn).toEqual(log.filter((record) => inTurn.includes(record)));
        for (const { flight } of inTurn) if (filter.of) expect(flight[filter.of.kind]).toBe(filter.of.id);
      }),
    );
  });

  it('finds every word of the text and the date, whatever its case and its marks', () => {
    const at = new Date(2025, 4, 9).getTime();
    const log = [
      recordOf({ id: '1', place: 'Gyűla', modelName: 'Lancer 07', round: 'fly-off 1' }),
      recordOf({ id: '2', place: 'GYULA', note: 'Thermal\nat once', at }),
    ];
    const found = (text: string) => filtered(log, { ...NO_FILTER, text }).map(({ key }) => key);
    const texts = ['', 'gyula', ' LANCER  gyu', 'thermal once', 'fly-off', 'lancer thermal', '2026', '2025-05-09 gyu'];
    expect(texts.map(found)).toEqual([['1', '2'], ['1', '2'], ['1'], ['2'], ['1'], [], ['1'], ['2']]);
  });
});

describe('the log by days', () => {
  it('has every flight once, in order, grouped by day and place', () => {
    fc.assert(
      fc.property(anyLog, (log) => {
        const days = [...grouped(log).values()];
        expect(days.flat().length).toBe(log.length);
        const places = days.map((records) => new Set(records.map(({ flight }) => `${dayOf(flight)}|${flight.place}`)));
        expect(places.map(({ size }) => size)).toEqual(days.map(() => 1));
        expect(new Set(places.flatMap((place) => [...place])).size).toBe(days.length);
        for (const records of days) {
          expect(records.map(({ flight }) => flight.at)).toEqual(
            records.map(({ flight }) => flight.at).sort((a, b) => b - a),
          );
        }
      }),
    );
  });

  it('end at the midnight of the pilot', () => {
    const shown = (at: Date): string[] => [dayOf({ at: at.getTime() }), timeOfDay({ at: at.getTime() })];
    expect(shown(new Date(2026, 2, 28, 23, 59))).toEqual(['2026-03-28', '23:59']);
    expect(shown(new Date(2026, 2, 29))).toEqual(['2026-03-29', '00:00']);
  });
});

describe('the clock of the field', () => {
  it.each([
    ['in Mongolia', 480, '2026-08-14', '06:30', 'UTC+08:00'],
    ['in California', -420, '2026-08-13', '15:30', 'UTC−07:00'],
    ['in Nepal', 345, '2026-08-14', '04:15', 'UTC+05:45'],
    ['in London in winter', 0, '2026-08-13', '22:30', 'UTC+00:00'],
  ])('stays with a flight, wherever it is read: %s', (_, utcOffset, day, time, text) => {
    onTestFinished(() => void vi.unstubAllEnvs());
    for (const zone of ['Asia/Ulaanbaatar', 'America/Los_Angeles', 'UTC']) {
      vi.stubEnv('TZ', zone);
      const flight = { at: Date.UTC(2026, 7, 13, 22, 30), utcOffset };
      expect([dayOf(flight), timeOfDay(flight), offsetText(flight)]).toEqual([day, time, text]);
      expect(momentOf(`${day}T${time}`, flight)).toBe(flight.at);
      expect(dayHeading(flight)).toContain(String(Number(day.slice(-2))));
      const isOurs = deviceOffset(flight.at) === utcOffset;
      expect(clockOf(flight)).toBe(isOurs ? time : `${time} ${text}`);
    }
  });

  it('is that of the device where a flight has none', () => {
    onTestFinished(() => void vi.unstubAllEnvs());
    vi.stubEnv('TZ', 'America/Los_Angeles');
    const flight = { at: Date.UTC(2026, 7, 13, 22, 30) };
    expect([dayOf(flight), clockOf(flight), offsetText(flight)]).toEqual(['2026-08-13', '15:30', '']);
    expect(momentOf('2026-08-13T15:30', flight)).toBe(flight.at);
    expect([momentOf('', flight), momentOf('', { utcOffset: 60 })]).toEqual([Number.NaN, Number.NaN]);
  });
});

it.each([
  [[180, 179.5, 300, null, 40.5], { best: 300, average: 175 }],
  [[180, 180, 179], { best: 180, average: 179.6 }],
  [Array<number>(6).fill(170.3), { best: 170.3, average: 170.3 }],
  [[180, null], { best: null, average: null }],
  [[], { best: null, average: null }],
])('the totals of %j: an average is never above the best, and a single result is neither', (results, totals) => {
  const log = results.map((result, at) => recordOf({ id: `${at}`, result }));
  expect(totalsOf(log)).toEqual({ flights: results.length, ...totals });
});

it('what was flown before gives places to choose from, the latest first', () => {
  expect(placesOf(['B', '', 'A', 'B'].map((place, at) => recordOf({ id: `${at}`, place })))).toEqual(['B', 'A']);
});

it('says what changed since the flight of the same model before', () => {
  const { program } = PLAIN;
  const longer = withValue(program, { kind: 'time', slot: 4 }, 21_000);
  const turned = withValue(longer, { kind: 'position', servo: 1, slot: 3 }, 56);
  const log = [
    recordOf({ id: 'all', model: 'lancer', program: programOf('Q', [900, 20, 90, 290, 18_000]) }),
    recordOf({ id: 'turned', model: 'lancer', program: turned }),
    recordOf({ id: 'nobody', program }),
    recordOf({ id: 'again', model: 'lancer', program: { ...longer, memory: 2 } }),
    recordOf({ id: 'longer', model: 'lancer', program: longer }),
    recordOf({ id: 'other', model: 'vega', program: programOf('B', [0, 30, 18_000]) }),
    recordOf({ id: 'first', model: 'lancer', program }),
    recordOf({ id: 'nobody-too', program: longer }),
    recordOf({ id: 'vega', model: 'vega', program }),
  ];
  const before = flownBefore(log);
  const said = log.flatMap(({ key, flight }) => {
    const last = before.get(key);
    return last ? [[key, changedText(last, flight.program).replaceAll('\u00a0', ' ')]] : [];
  });
  expect(said).toEqual([
    ['all', '6 values changed'],
    ['turned', 'Function 3, S2: 23 → 56'],
    ['again', ''],
    ['longer', 'DT: 3:00 min → 3:30 min'],
    ['other', 'another timer'],
  ]);
});
