import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { Flight, Model } from '../../program/index.js';
import { dayOf, timeOfDay } from './flight-list.js';
import type { FlightLog } from './flight-log.js';
import { type Measure, measureText, RANGES, type ReadMeasure, readMeasure, steppedMeasure } from './measures.js';

/** Why what was typed is no value. */
export type Problem = Extract<ReadMeasure, { unreadable: unknown }>['unreadable'] | 'not-a-date';
type Field = Measure | 'at';

/**
 * One flight that is filled in. What can be read is in the log at once, so that nothing typed is lost; what cannot be
 * read stays in its field.
 */
export class FlightForm {
  readonly flight: ReadonlySignal<Flight>;
  /** What was changed since the form was opened. */
  readonly changed: ReadonlySignal<boolean>;
  readonly problems: ReadonlySignal<ReadonlyMap<Field, Problem>>;
  readonly #changes = signal<Partial<Flight>>({}, { name: 'flightChanges' });
  /** As they stand in their fields where they are not what the flight would say. */
  readonly #texts = signal<ReadonlyMap<Field, string>>(new Map(), { name: 'flightTexts' });
  readonly #log: FlightLog;
  readonly #opened: Flight;
  /** The same day before: wind and temperature change slowly. */
  readonly #before: Flight | null;
  #waits = false;
  #keeping = false;

  /** @param before the flight before this one. */
  constructor(log: FlightLog, opened: Flight, before: Flight | null) {
    this.#log = log;
    this.#opened = opened;
    this.#before = before && dayOf(before.at) === dayOf(opened.at) ? before : null;
    this.flight = computed(() => ({ ...opened, ...this.#changes.value }));
    this.changed = computed(
      () =>
        this.#texts.value.size > 0 ||
        Object.entries(this.#changes.value).some(([name, value]) => opened[name as keyof Flight] !== value),
    );
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
  }

  /** What stands in the field of a number. */
  textOf(measure: Measure): string {
    return this.#texts.value.get(measure) ?? measureText(this.flight.value[measure]);
  }

  /** What stands in the field of the date: `2026-11-22T14:05`. */
  get when(): string {
    const { at } = this.flight.value;
    return this.#texts.value.get('at') ?? `${dayOf(at)}T${timeOfDay(at)}`;
  }

  type(measure: Measure, text: string): void {
    const read = readMeasure(measure, text);
    this.#text(measure, text);
    if ('value' in read) this.#change({ [measure]: read.value });
  }

  /** The field was left: what it says stands in it as it is written elsewhere. */
  leave(measure: Measure): void {
    if (!this.problems.peek().has(measure)) this.#text(measure, null);
  }

  /** One step up or down; the first tap of an empty field takes what it was on the flight before. */
  step(measure: Measure, direction: 1 | -1): void {
    const value = this.flight.peek()[measure];
    const next =
      value === null ? (this.#before?.[measure] ?? RANGES[measure].first) : steppedMeasure(measure, value, direction);
    this.#text(measure, null);
    this.#change({ [measure]: next });
  }

  /** A date and a time of day as a browser gives them. */
  setWhen(text: string): void {
    const at = text === '' ? Number.NaN : new Date(text).getTime();
    const isDate = at >= 0;
    this.#text('at', isDate ? null : text);
    if (isDate) this.#change({ at });
  }

  setRound(round: string): void {
    this.#change({ round });
  }

  /** The round of a button; pressed once more it is taken back. */
  pickRound(round: string): void {
    this.setRound(this.flight.peek().round === round ? '' : round);
  }

  setPlace(place: string): void {
    this.#change({ place });
  }

  setNote(note: string): void {
    this.#change({ note });
  }

  /** @param model null: none of the library. */
  setModel(model: Model | null): void {
    this.#change({ model: model?.id ?? null, modelName: model?.name ?? '' });
  }

  /** Everything as it was when the form was opened. */
  undo(): void {
    this.#texts.value = new Map();
    const names = Object.keys(this.#changes.peek()) as (keyof Flight)[];
    // What another tab has changed meanwhile, and this form has not, stays.
    this.#change(Object.fromEntries(names.map((name) => [name, this.#opened[name]])));
  }

  #text(field: Field, text: string | null): void {
    const texts = new Map(this.#texts.peek());
    if (text === null) texts.delete(field);
    else texts.set(field, text);
    this.#texts.value = texts;
  }

  #change(changes: Partial<Flight>): void {
    this.#changes.value = { ...this.#changes.peek(), ...changes };
    void this.#keep();
  }

  /** One at a time: while one is kept the next ones wait together. */
  async #keep(): Promise<void> {
    this.#waits = true;
    if (this.#keeping) return;
    this.#keeping = true;
    while (this.#waits) {
      this.#waits = false;
      await this.#log.change(this.#opened.id, this.#changes.peek());
    }
    this.#keeping = false;
  }
}
