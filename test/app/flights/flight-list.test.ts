import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type FlightFilter, NO_FILTER, PERIODS } from '../../../src/app/flights/flight-filter.js';
import {
  dayOf,
  filtered,
  grouped,
  midnight,
  modelsOf,
  placesOf,
  rangeOf,
  timeOfDay,
  totalsOf,
} from '../../../src/app/flights/flight-list.js';
import { anyLog, recordOf } from './flights.js';

const NOW = new Date(2026, 0, 18, 12).getTime();
const day = fc.constantFrom('', '2026-01-05', '2026-01-12', 'soon');
const anyFilter: fc.Arbitrary<FlightFilter> = fc.record({
  model: fc.constantFrom('all' as const, 'none' as const, { id: 'lancer' }, { id: 'gone' }),
  setting: fc.constantFrom(null, 'calm'),
  place: fc.constantFrom(null, 'Gyula', ''),
  text: fc.constantFrom('', 'a', 'gyu 1', 'É'),
  period: fc.constantFrom(...PERIODS),
  from: day,
  until: day,
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
        const { period, from, until, ...rest } = filter;
        const parts = [...Object.entries(rest).map(([name, value]) => ({ [name]: value })), { period, from, until }];
        // One part at a time, in any order, is the same.
        const inTurn = parts.reduceRight(
          (left, part) => filtered(left, { ...NO_FILTER, ...part }, NOW),
          log as ReturnType<typeof filtered>,
        );
        expect(filtered(log, filter, NOW)).toEqual(inTurn);
        const days = { all: '', today: '2026-01-18', month: '2025-12-19', year: '2026-01-01', own: from };
        for (const { flight } of inTurn) {
          if (filter.place !== null) expect(flight.place).toBe(filter.place);
          if (/^\d/.test(days[period])) expect(dayOf(flight.at) >= days[period]).toBe(true);
          if (period === 'own' && /^\d/.test(until)) expect(dayOf(flight.at) <= until).toBe(true);
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

describe('a period', () => {
  it.each([
    ['today', new Date(2026, 0, 18), null],
    ['month', new Date(2025, 11, 19), null],
    ['year', new Date(2026, 0, 1), null],
    ['own', new Date(2026, 0, 3), new Date(2026, 0, 6)],
    ['all', null, null],
  ] as const)('%s', (period, from, before) => {
    expect(rangeOf({ period, from: '2026-01-03', until: '2026-01-05' }, NOW)).toEqual({
      from: from?.getTime() ?? null,
      before: before?.getTime() ?? null,
    });
  });
});

describe('the log by days', () => {
  it('has every flight once, in order, grouped by day and place', () => {
    fc.assert(
      fc.property(anyLog, (log) => {
        const days = grouped(log);
        expect(days.flatMap(({ records }) => records).length).toBe(log.length);
        expect(new Set(days.map(({ key }) => key)).size).toBe(days.length);
        for (const { at, place, records } of days) {
          expect(records[0]?.flight.at).toBe(at);
          expect(new Set(records.map(({ flight }) => `${dayOf(flight.at)}|${flight.place}`))).toEqual(
            new Set([`${dayOf(at)}|${place}`]),
          );
          expect(records.map(({ flight }) => flight.at)).toEqual(
            records.map(({ flight }) => flight.at).sort((a, b) => b - a),
          );
        }
      }),
    );
  });

  it('ends at the midnight of the pilot, also where a clock is changed', () => {
    const evening = new Date(2026, 2, 28, 23, 59).getTime();
    expect([dayOf(evening), timeOfDay(evening)]).toEqual(['2026-03-28', '23:59']);
    expect(dayOf(midnight(evening, 1))).toBe('2026-03-29');
    expect(timeOfDay(midnight(evening, 1))).toBe('00:00');
    expect(timeOfDay(midnight(evening, 2))).toBe('00:00');
  });
});

describe('the totals', () => {
  it('count flights, the best and average result, and full rounds without fly-offs', () => {
    const log = [
      recordOf({ id: '1', result: 180, round: '1' }),
      recordOf({ id: '2', result: 179.5, round: '2' }),
      recordOf({ id: '3', result: 300, round: 'fly-off 1' }),
      recordOf({ id: '4', round: '3' }),
      recordOf({ id: '5', result: 40.5 }),
    ];
    expect(totalsOf(log)).toEqual({ flights: 5, best: 300, average: 175, rounds: 2, maxima: 1 });
    expect(totalsOf(log.slice(4)), 'a single result is no best and no average').toMatchObject({
      flights: 1,
      best: null,
      average: null,
    });
    expect(totalsOf([])).toEqual({ flights: 0, best: null, average: null, rounds: 0, maxima: 0 });
  });

  it('are always possible', () => {
    fc.assert(
      fc.property(anyLog, (log) => {
        const { flights, best, average, rounds, maxima } = totalsOf(log);
        expect(flights).toBe(log.length);
        expect(maxima).toBeLessThanOrEqual(rounds);
        expect(average === null).toBe(best === null);
        if (best !== null && average !== null) expect(average).toBeLessThanOrEqual(best + 1e-9);
      }),
    );
  });
});

describe('what was flown before', () => {
  it('gives places and models to choose from, the latest first, under their latest name', () => {
    const log = [
      recordOf({ id: '1', place: 'B', model: 'x', modelName: 'Lancer 08' }),
      recordOf({ id: '2', place: '' }),
      recordOf({ id: '3', place: 'A', model: 'x', modelName: 'Lancer' }),
      recordOf({ id: '4', place: 'B', model: 'y', modelName: 'Vega' }),
    ];
    expect(placesOf(log)).toEqual(['B', 'A']);
    expect([...modelsOf(log)]).toEqual([
      ['x', 'Lancer 08'],
      ['y', 'Vega'],
    ]);
  });
});
