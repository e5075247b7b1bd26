import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { Flight } from '../../program/index.js';
import type { Ambiguous } from '../editing/units.js';
import { dayOf, momentOf, nextRound, timeOfDay } from './flight-list.js';
import type { FlightLog } from './flight-log.js';
import { type Measure, measureText, RANGES, type ReadMeasure, readMeasure, steppedMeasure } from './measures.js';

/** Why a typed text is no value. */
export type Problem = Extract<ReadMeasure, { unreadable: unknown }>['unreadable'] | 'not-a-date';
type Field = Measure | 'at';

/**
 * A flight in its form. A value goes into the log at once, so nothing typed is lost.
 * A text that is no value stays in its field.
 */
export class FlightForm {
  readonly flight: ReadonlySignal<Flight>;
  readonly problems: ReadonlySignal<ReadonlyMap<Field, Problem>>;
  /** What the result may mean; null where its text is clear. */
  readonly either: ReadonlySignal<Ambiguous['either'] | null>;
  /** The round after the last one of the day, and the last wind, while neither is noted; null for none. */
  readonly proposed: ReadonlySignal<Pick<Flight, 'round' | 'wind'> | null>;
  readonly #changes = signal<Partial<Flight>>({}, { name: 'flightChanges' });
  /** The texts of the fields, where they differ from what the flight would show. */
  readonly #texts = signal<ReadonlyMap<Field, string>>(new Map(), { name: 'flightTexts' });
  readonly #log: FlightLog;
  readonly #opened: Flight;
  /** What was noted last on the same day: wind and temperature change slowly. Rounds are those of the model. */
  readonly #before: Pick<Flight, Measure | 'round'>;
  /** The value of the field that is being typed in, from before that. */
  #resting: number | null = null;

  /** @param before the flights before this one, the latest first. */
  constructor(log: FlightLog, opened: Flight, before: readonly Flight[]) {
    this.#log = log;
    this.#opened = opened;
    const today = before.filter((flight) => dayOf(flight) === dayOf(opened));
    this.#before = { ...lastNoted(today), ...lastRound(today, opened) };
    this.flight = computed(() => ({ ...opened, ...this.#changes.value }));
    this.problems = computed(
      () =>
        new Map(
          [...this.#texts.value].flatMap(([field, text]): [Field, Problem][] => {
            if (field === 'at') return [[field, 'not-a-date']];
            const read = readMeasure(field, text);
            return 'unreadable' in read ? [[field, read.unreadable]] : [];
          }),
        ),
    );
    this.either = computed(() => {
      const read = readMeasure('result', this.#texts.value.get('result') ?? '');
      return 'either' in read ? read.either : null;
    });
    this.proposed = computed(() => {
      const { round, wind } = this.flight.value;
      const next = { round: nextRound(this.#before.round), wind: this.#before.wind };
      return round !== '' || wind !== null || (next.round === '' && next.wind === null) ? null : next;
    });
  }

  /** Notes what was proposed. */
  takeProposed(): void {
    this.#change(this.proposed.peek() ?? {});
  }

  /** Says what the text of the result means, in hundredths of a second; null takes the text back. */
  answer(hundredths: number | null): void {
    this.#text('result', null);
    if (hundredths !== null) this.#change({ result: hundredths / 100 });
  }

  /** The text in the field of a number. */
  textOf(measure: Measure): string {
    return this.#texts.value.get(measure) ?? measureText(this.flight.value[measure]);
  }

  /** The text in the field of the date: `2026-11-22T14:05`. */
  get when(): string {
    const flight = this.flight.value;
    return this.#texts.value.get('at') ?? `${dayOf(flight)}T${timeOfDay(flight)}`;
  }

  type(measure: Measure, text: string): void {
    const read = readMeasure(measure, text);
    if (!this.#texts.peek().has(measure)) this.#resting = this.flight.peek()[measure];
    this.#text(measure, text);
    if ('value' in read) this.#change({ [measure]: read.value });
    // Before `2.58` the text was `2` for a moment.
    if ('either' in read) this.#change({ [measure]: this.#resting });
  }

  /** The field was left: its value gets the usual form. */
  leave(measure: Measure): void {
    if (!this.problems.peek().has(measure)) this.#text(measure, null);
  }

  /** One step up or down. In an empty field, the first tap takes the value of the flight before. */
  step(measure: Measure, direction: 1 | -1): void {
    const value = this.flight.peek()[measure];
    const next =
      value === null ? (this.#before[measure] ?? RANGES[measure].first) : steppedMeasure(measure, value, direction);
    this.#text(measure, null);
    this.#change({ [measure]: next });
  }

  /** Sets date and time of day from the text of a browser's field. */
  setWhen(text: string): void {
    const at = momentOf(text, this.flight.peek());
    const isDate = at >= 0;
    this.#text('at', isDate ? null : text);
    if (isDate) this.#change({ at });
  }

  /** Changes what needs no reading. */
  set(changes: Partial<Pick<Flight, 'round' | 'place' | 'note' | 'model' | 'modelName'>>): void {
    this.#change(changes);
  }

  #text(field: Field, text: string | null): void {
    const texts = new Map(this.#texts.peek());
    if (text === null) texts.delete(field);
    else texts.set(field, text);
    this.#texts.value = texts;
  }

  #change(changes: Partial<Flight>): void {
    this.#changes.value = { ...this.#changes.peek(), ...changes };
    void this.#log.change(this.#opened.id, changes);
  }
}

/** The last that was noted of each, in flights with the latest first. */
function lastNoted(flights: readonly Flight[]): Pick<Flight, Measure> {
  const last = (measure: Measure): number | null =>
    flights.find((flight) => flight[measure] !== null)?.[measure] ?? null;
  return { wind: last('wind'), temperature: last('temperature'), result: last('result') };
}

/** The last round that this model flew; of a model that has flown none, that of any: it may take over in a contest. */
function lastRound(flights: readonly Flight[], { model }: Flight): Pick<Flight, 'round'> {
  const rounds = flights.filter(({ round }) => round !== '');
  return { round: (rounds.find((flight) => flight.model === model) ?? rounds[0])?.round ?? '' };
}
