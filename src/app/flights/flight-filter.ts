/** The address of the log, after `#library/`. */
export const FLIGHTS = 'flights';

/** Whose flights to show: all; those of one model, by its id; those of no model in the library. */
export type ModelFilter = 'all' | 'none' | { readonly id: string };

export const PERIODS = ['all', 'today', 'month', 'year', 'own'] as const;
type Period = (typeof PERIODS)[number];

/** Which flights of the log are shown. An empty field filters nothing. */
export interface FlightFilter {
  readonly model: ModelFilter;
  /** A setting by its id; null for any. */
  readonly setting: string | null;
  readonly place: string | null;
  /** Words that must stand somewhere in the texts of a flight. */
  readonly text: string;
  readonly period: Period;
  /** The first and the last day of a period, as `2026-11-22`. Empty: open. */
  readonly from: string;
  readonly until: string;
}

export const NO_FILTER: FlightFilter = {
  model: 'all',
  setting: null,
  place: null,
  text: '',
  period: 'all',
  from: '',
  until: '',
};
