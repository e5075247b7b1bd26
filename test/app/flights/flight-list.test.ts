import fc from 'fast-check';
import { describe, expect, it, onTestFinished, vi } from 'vitest';
import { type FlightFilter, NO_FILTER, PERIODS } from '../../../src/app/flights/flight-filter.js';
import {
  beginOf,
  dayOf,
  deviceOffset,
  filtered,
  flownBefore,
  grouped,
  momentOf,
  nextRound,
  offsetText,
  placesOf,
  timeOfDay,
  totalsOf,
} from '../../../src/app/flights/flight-list.js';
import { changedText, clockOf, dayHeading } from '../../../src/app/flights/flight-text.js';
import { withValue } from '../../../src/program/index.js';
import { programOf } from '../programs.js';
import { anyLog, PLAIN, recordOf } from './flights.js';

const NOW = new Date(2026, 0, 18, 12).getTime();
const anyFilter: fc.Arbitrary<FlightFilter> = fc.record({
  of: fc.constantFrom(null, ...(['lancer', 'gone'] as const).map((id) => ({ kind: 'model', id, name: '' }) as const), {
    kind: 'setting',
    id: 'calm',
    name: '',
  } as const),
  text: fc.constantFrom('', 'a', 'gyu 1', 'É'),
  period: fc.constantFrom(...PERIODS),
  day: fc.constantFrom(null, '2026-01-10 Wiese', '2026-01-11 '),
});

describe('the filter of the log', () => {
  it('shows all flights in their order when nothing is asked', () => {
    fc.assert(
      fc.property(anyLog, (log) => {
        expect(filtered(log, NO_FILTER, NOW)).toEqual(log);
      }),
    );
  });

  it('shows exactly the flights that fit every part of it', () => {
    fc.assert(
      fc.property(anyLog, anyFilter, (log, filter) => {
        const parts = Object.entries(filter).map(([name, value]) => ({ [name]: value }));
        // One part at a time, in any order, is the same.
        const inTurn = parts.reduceRight<ReturnType<typeof filtered>>(
          (left, part) => filtered(left, { ...NO_FILTER, ...part }, NOW),
          log,
        );
        expect(filtered(log, filter, NOW)).toEqual(inTurn);
        const days = { all: '', today: '2026-01-18', year: '2026-01-01' };
        for (const { flight } of inTurn) {
          if (filter.of) expect(flight[filter.of.kind]).toBe(filter.of.id);
          expect(dayOf(flight) >= days[filter.period]).toBe(true);
        }
      }),
    );
  });

  it('finds every word of the text, whatever its case and its marks', () => {
    const log = [
      recordOf({ id: '1', place: 'Gyűla', modelName: 'Lancer 07', round: 'fly-off 1' }),
      recordOf({ id: '2', place: 'GYULA', note: 'Thermal\nat once' }),
    ];
    const found = (text: string) => filtered(log, { ...NO_FILTER, text }, NOW).map(({ key }) => key);
    expect([
      found('gyula'),
      found(' LANCER  gyu'),
      found('thermal once'),
      found('fly-off'),
      found('lancer thermal'),
    ]).toEqual([['1', '2'], ['1'], ['2'], ['1'], []]);
  });
});

it.each([
  ['today', NOW, new Date(2026, 0, 18).getTime()],
  ['today', new Date(2026, 2, 29, 23, 59).getTime(), new Date(2026, 2, 29).getTime()],
  ['year', NOW, new Date(2026, 0, 1).getTime()],
  ['all', NOW, Number.NEGATIVE_INFINITY],
] as const)(
  'the period %s at %i begins at its first millisecond, also where a clock was changed',
  (period, now, begin) => {
    expect(beginOf(period, now)).toBe(begin);
  },
);

describe('the log by days', () => {
  it('has every flight once, in order, grouped by day and place', () => {
    fc.assert(
      fc.property(anyLog, (log) => {
        const days = grouped(log);
        expect(days.flatMap(({ records }) => records).length).toBe(log.length);
        expect(new Set(days.map(({ key }) => key)).size).toBe(days.length);
        for (const { latest, place, records } of days) {
          expect(records[0]?.flight).toBe(latest);
          expect(new Set(records.map(({ flight }) => `${dayOf(flight)}|${flight.place}`))).toEqual(
            new Set([`${dayOf(latest)}|${place}`]),
          );
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

describe('the next round', () => {
  it.each([
    ['3', '4'],
    ['9', '10'],
    ['fly-off 1', 'fly-off 2'],
    ['Round 2', 'Round 3'],
    ['fly-off', ''],
    ['', ''],
  ])('after “%s” is “%s”', (round, next) => {
    expect(nextRound(round)).toBe(next);
  });
});

describe('the totals', () => {
  it('count flights, and give the best and the average result', () => {
    const log = [
      recordOf({ id: '1', result: 180, round: '1' }),
      recordOf({ id: '2', result: 179.5, round: '2' }),
      recordOf({ id: '3', result: 300, round: 'fly-off 1' }),
      recordOf({ id: '4', round: '3' }),
      recordOf({ id: '5', result: 40.5 }),
    ];
    expect(totalsOf(log)).toEqual({ flights: 5, best: 300, average: 175 });
    expect(totalsOf(log.slice(4)), 'a single result is no best and no average').toMatchObject({
      flights: 1,
      best: null,
      average: null,
    });
    expect(totalsOf([])).toEqual({ flights: 0, best: null, average: null });
  });

  it('are always possible', () => {
    fc.assert(
      fc.property(anyLog, (log) => {
        const { flights, best, average } = totalsOf(log);
        expect(flights).toBe(log.length);
        expect(average === null).toBe(best === null);
        if (best !== null && average !== null) expect(average).toBeLessThanOrEqual(best + 1e-9);
      }),
    );
  });
});

describe('what was flown before', () => {
  it('gives places to choose from, the latest first', () => {
    const log = [
      recordOf({ id: '1', place: 'B', model: 'x', modelName: 'Lancer 08' }),
      recordOf({ id: '2', place: '' }),
      recordOf({ id: '3', place: 'A', model: 'x', modelName: 'Lancer' }),
      recordOf({ id: '4', place: 'B', model: 'y', modelName: 'Vega' }),
    ];
    expect(placesOf(log)).toEqual(['B', 'A']);
  });
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
