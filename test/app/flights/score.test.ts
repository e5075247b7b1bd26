import fc from 'fast-check';
import { describe, expect, it, test } from 'vitest';
import { roundNumber } from '../../../src/app/flights/flight-list.js';
import { type ScoreLine, scoreOf } from '../../../src/app/flights/score.js';
import { scoreText } from '../../../src/app/flights/score-text.js';
import type { Flight } from '../../../src/program/index.js';
import { anyFlight, PLAIN, recordOf } from './flights.js';

/** Flights of a day, an hour apart, given as round, result, and what else is known. */
type Flown = readonly [round: string, result: number | null, more?: Partial<Flight>];
const flightsOf = (flown: readonly Flown[]): Flight[] =>
  flown.map(([round, result, more], at) => {
    return recordOf({ id: `f${at}`, at: PLAIN.at + at * 3_600_000, round, result, ...more }).flight;
  });
/** The newest first, as in the log. */
const scored = (...flown: readonly Flown[]) => scoreOf(flightsOf(flown).reverse());
const shown = (lines: readonly ScoreLine[]) =>
  lines.map(({ flight, maximum, points }) => [flight.round, flight.result, maximum, points]);

describe('the total of a day', () => {
  it('counts each round up to its maximum: its own, else that of the day', () => {
    const { total, maximum, rounds } = scored(
      ['1', 251, { maximum: 240 }],
      ['2', 200, { maximum: 180 }],
      ['3', 171.5, { maximum: 180 }],
      ['4', 190],
    );
    expect([total, maximum]).toEqual([240 + 180 + 171.5 + 180, 180]);
    expect(shown(rounds)).toEqual([
      ['1', 251, 240, 240],
      ['2', 200, 180, 180],
      ['3', 171.5, 180, 171.5],
      ['4', 190, 180, 180],
    ]);
  });

  it.each([
    ['no maximum: each result counts in full', '1 200, 2 100', null, 300],
    ['no result: the round adds nothing', '1 180/180, 2 ', 180, 180],
    ['tenths and hundredths add up exactly', '1 0.1, 2 0.2, 3 171.33', null, 171.63],
    ['a maximum with decimals', '1 180/150.5', 150.5, 150.5],
    ['of equally many maxima that of the latest round', '1 300/240, 2 300/180, 3 300', 180, 600],
    ['the same, whatever was flown first', '2 300/180, 1 300/240', 180, 420],
    ['a round with another maximum is not the rule', '1 300/180, 2 300/180, 3 300/120, 4 300', 180, 660],
    ['nothing at all', '', null, 0],
  ])('%s', (_, flown, maximum, total) => {
    // Round, result and maximum of each flight.
    const flights = flown.matchAll(/(\d) ([\d.]*)(?:\/([\d.]+))?/g);
    const score = scored(
      ...[...flights].map(([, round = '', result = '', most]): Flown => {
        return [round, result === '' ? null : Number(result), most === undefined ? {} : { maximum: Number(most) }];
      }),
    );
    expect([score.maximum, score.total]).toEqual([maximum, total]);
  });

  it('never has two flights of a round: the last one with a result counts, or the one that was chosen', () => {
    const twice = (...more: readonly Partial<Flight>[]) =>
      scored(['1', 150, more[0] ?? {}], ['01', 170, more[1] ?? {}], [' 1. ', null, more[2] ?? {}], ['2', 10]);
    expect(twice().rounds.map(({ points }) => points)).toEqual([null, 170, null, 10]);
    expect(twice({ counts: true }).total).toBe(160);
    expect(twice({ counts: true }, { counts: true }).total, 'two were chosen, on two devices').toBe(180);
    expect(twice({}, {}, { counts: true }).total, 'the chosen one has no result yet').toBe(10);
    expect(twice({ maximum: 140 }).total, 'the maximum is that of the round, whichever flight has it').toBe(150);
  });

  it('is that of numbered rounds: fly-offs stand after it, each with its own maximum or none', () => {
    const score = scored(
      ['fly-off', 400, { maximum: 300 }],
      ['1', 180, { maximum: 180 }],
      ['Fly-Off 2', 421.5],
      ['FLY-OFF', 290],
      ['', 99],
      ['2 again', 99],
    );
    expect(shown(score.rounds)).toEqual([['1', 180, 180, 180]]);
    expect(score.total).toBe(180);
    expect(shown(score.others)).toEqual([
      ['fly-off', 400, 300, null],
      ['FLY-OFF', 290, 300, 290],
      ['Fly-Off 2', 421.5, null, 421.5],
      ['', 99, null, null],
      ['2 again', 99, null, 99],
    ]);
  });

  it('shows each flight once, counts one of each round, and never more than was flown', () => {
    fc.assert(
      fc.property(fc.uniqueArray(anyFlight, { selector: ({ id }) => id, maxLength: 20 }), (flights) => {
        const { rounds, others, total } = scoreOf(flights);
        const lines = [...rounds, ...others];
        expect(lines.map(({ flight }) => flight.id).sort()).toEqual(flights.map(({ id }) => id).sort());
        for (const { round, flight } of lines) {
          const counting = lines.filter((line) => line.round === round && line.counts);
          expect(counting.length).toBe(flight.round.trim() === '' ? 0 : 1);
        }
        const flown = rounds.reduce((sum, { flight }) => sum + (flight.result ?? 0), 0);
        expect(total).toBeLessThanOrEqual(flown + 1e-6);
      }),
    );
  });
});

test.each([
  ['3', 3],
  [' 12 ', 12],
  ['3.', 3],
  ['03', 3],
  ['3/5', 3],
  ['', null],
  ['fly-off 1', null],
  ['1st', null],
  ['2. стечене', null],
])('%j is round %j', (round, number) => {
  expect(roundNumber(round)).toBe(number);
});

describe('as text', () => {
  it('reads well in a message and goes into a sheet', () => {
    const score = scored(
      ['1', 251, { maximum: 240, modelName: 'Lancer 07' }],
      ['2', 120.5],
      ['2', 171.5, { maximum: 180, modelName: 'Vega' }],
      ['3', null, { maximum: 180 }],
      ['fly-off 1', 312],
      ['', 20],
    );
    expect(scoreText(score)).toBe(
      [
        'Sun, 22 Nov 2026',
        'Lancer 07, Vega',
        '',
        'Round\tResult\tMaximum\tCounted',
        '1\t251\t240\t240',
        '2\t120.5\t\tnot counted',
        '2\t171.5\t180\t171.5',
        '3\t\t180\tno result',
        'Total\t\t\t411.5',
        'Fly-off 1\t312\t\t312',
      ].join('\n'),
    );
  });

  it('has neither a tab nor a line end nor a formula of what was typed', () => {
    const score = scored(['=1+1', 1, { place: 'A\tB\nC', modelName: '@SUM(1)' }]);
    expect(scoreText(score).split('\n')).toEqual([
      'Sun, 22 Nov 2026',
      'A B C',
      "'@SUM(1)",
      '',
      'Round\tResult\tMaximum\tCounted',
      "'=1+1\t1\t\t1",
    ]);
  });
});
