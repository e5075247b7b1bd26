/** Where the log is, in the address after `#library/`. */
export const FLIGHTS = 'flights';

/** Whose flights are looked for: all; those of one model, by its id; those of no model of the library. */
export type ModelFilter = 'all' | 'none' | { readonly id: string };

export const PERIODS = ['all', 'today', 'month', 'year', 'own'] as const;
export type Period = (typeof PERIODS)[number];

/** What of the log is shown. What is empty asks for nothing. */
export interface FlightFilter {
  readonly model: ModelFilter;
  /** A setting by its id. */
  readonly setting: string | null;
  readonly place: string | null;
  /** Words that have to stand somewhere in the texts of a flight. */
  readonly text: string;
  readonly period: Period;
  /** The first and the last day of a period of one's own, as `2026-11-22`; empty: open. */
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
