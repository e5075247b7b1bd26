/** The address of the log, after `#library/`. */
export const FLIGHTS = 'flights';

export const PERIODS = ['all', 'today', 'year'] as const;
type Period = (typeof PERIODS)[number];

/** Which flights of the log are shown. An empty field filters nothing. */
export interface FlightFilter {
  /** A model by its id; null for any. */
  readonly model: string | null;
  /** A saved program by its id; null for any. */
  readonly setting: string | null;
  /** Words that must stand somewhere in the texts of a flight. */
  readonly text: string;
  readonly period: Period;
}

export const NO_FILTER: FlightFilter = { model: null, setting: null, text: '', period: 'all' };
