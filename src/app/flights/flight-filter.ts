/** The address of the log, after `#library/`. */
export const FLIGHTS = 'flights';

/** A model, or a saved program, whose flights are shown. */
export interface FlownBy {
  readonly kind: 'model' | 'setting';
  readonly id: string;
  readonly name: string;
}

/** Which flights of the log are shown. An empty field filters nothing. */
export interface FlightFilter {
  /** Whose flights; null for all. */
  readonly of: FlownBy | null;
  /** Words that must stand somewhere in the date or the texts of a flight. */
  readonly text: string;
  /** The key of the day and place whose score card is shown; null for none. */
  readonly day: string | null;
}

export const NO_FILTER: FlightFilter = { of: null, text: '', day: null };
