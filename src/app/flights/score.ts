import type { Flight } from '../../program/index.js';
import { foldedText } from '../messages/search.js';
import { roundNumber } from './flight-list.js';

/** A flight on a score card. */
export interface ScoreLine {
  readonly flight: Flight;
  /** All flights of its round, in the order of time. */
  readonly round: readonly Flight[];
  /** Whether it is the one of its round that counts. Without a round, none does. */
  readonly counts: boolean;
  /** The maximum that was typed for its round, in seconds; null for none. */
  readonly own: number | null;
  /** That, or for a numbered round that of the day. */
  readonly maximum: number | null;
  /** What counts, in seconds; null for nothing. */
  readonly points: number | null;
}

/** The flights of one day and place as a contestant adds them up. No rule of any class is in it. */
export interface Score {
  /** What most rounds have as their own maximum, of equally many the latest; null for none. */
  readonly maximum: number | null;
  /** Numbered rounds, in their order. */
  readonly rounds: readonly ScoreLine[];
  /** What is not in the total, in the order of time: fly-offs, all else without a plain number, no round. */
  readonly others: readonly ScoreLine[];
  /** In seconds. */
  readonly total: number;
  /** The names of the models. */
  readonly models: readonly string[];
}

export function scoreOf(given: readonly Flight[]): Score {
  const flights = [...given].sort((a, b) => a.at - b.at);
  const byRound = new Map<number | string, Flight[]>();
  for (const flight of flights) {
    const key = roundNumber(flight.round) ?? foldedText(flight.round).trim();
    byRound.set(key, [...(byRound.get(key) ?? []), flight]);
  }
  const numbered = [...byRound].filter(([key]) => typeof key === 'number').sort(([a], [b]) => Number(a) - Number(b));
  const maximum = commonest(numbered.flatMap(([, round]) => maximumIn(round) ?? []));
  const rounds = numbered.flatMap(([, round]) => linesOf(round, maximum));
  const sum = rounds.reduce((all, { points }) => all + (points ?? 0), 0);
  return {
    maximum,
    rounds,
    others: [...byRound].flatMap(([key, round]) => (typeof key === 'string' ? linesOf(round, null) : [])),
    // A sum of tenths has a rounding error.
    total: Math.round(sum * 1e6) / 1e6,
    models: [...new Set(flights.map(({ modelName }) => modelName))].filter(Boolean),
  };
}

function linesOf(round: readonly Flight[], ofDay: number | null): ScoreLine[] {
  const last = (fits: (flight: Flight) => unknown): Flight | undefined => round.filter(fits).at(-1);
  const counting = last(({ counts }) => counts) ?? last(({ result }) => result !== null) ?? round.at(-1);
  const own = maximumIn(round);
  const maximum = own ?? ofDay;
  return round.map((flight) => {
    const counts = flight === counting && flight.round.trim() !== '';
    const points = counts && flight.result !== null ? Math.min(flight.result, maximum ?? flight.result) : null;
    return { flight, round, counts, own, maximum, points };
  });
}

function maximumIn(round: readonly Flight[]): number | null {
  return round.flatMap(({ maximum }) => maximum ?? []).at(-1) ?? null;
}

function commonest(values: readonly number[]): number | null {
  const times = (value: number): number => values.filter((each) => each === value).length;
  return values.reduce<number | null>(
    (best, each) => (best === null || times(each) >= times(best) ? each : best),
    null,
  );
}
