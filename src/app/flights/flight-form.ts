import { computed, type ReadonlySignal, signal } from '@preact/signals';
import type { Flight, Model } from '../../program/index.js';
import { dayOf, timeOfDay } from './flight-list.js';
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
  /** Whether anything has changed since the form was opened. */
  readonly changed: ReadonlySignal<boolean>;
  readonly problems: ReadonlySignal<ReadonlyMap<Field, Problem>>;
  readonly #changes = signal<Partial<Flight>>({}, { name: 'flightChanges' });
  /** The texts of the fields, where they differ from what the flight would show. */
  readonly #texts = signal<ReadonlyMap<Field, string>>(new Map(), { name: 'flightTexts' });
  readonly #log: FlightLog;
  readonly #opened: Flight;
  /** The flight before on the same day: wind and temperature change slowly. */
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

  /** The text in the field of a number. */
  textOf(measure: Measure): string {
    return this.#texts.value.get(measure) ?? measureText(this.flight.value[measure]);
  }

  /** The text in the field of the date: `2026-11-22T14:05`. */
  get when(): string {
    const { at } = this.flight.value;
    return this.#texts.value.get('at') ?? `${dayOf(at)}T${timeOfDay(at)}`;
  }

  type(measure: Measure, text: string): void {
    const read = readMeasure(measure, text);
    this.#text(measure, text);
    if ('value' in read) this.#change({ [measure]: read.value });
  }

  /** The field was left: its value gets the usual form. */
  leave(measure: Measure): void {
    if (!this.problems.peek().has(measure)) this.#text(measure, null);
  }

  /** One step up or down. In an empty field, the first tap takes the value of the flight before. */
  step(measure: Measure, direction: 1 | -1): void {
    const value = this.flight.peek()[measure];
    const next =
      value === null ? (this.#before?.[measure] ?? RANGES[measure].first) : steppedMeasure(measure, value, direction);
    this.#text(measure, null);
    this.#change({ [measure]: next });
  }

  /** Sets date and time of day from the text of a browser's field. */
  setWhen(text: string): void {
    const at = text === '' ? Number.NaN : new Date(text).getTime();
    const isDate = at >= 0;
    this.#text('at', isDate ? null : text);
    if (isDate) this.#change({ at });
  }

  setRound(round: string): void {
    this.#change({ round });
  }

  /** Sets the round of a button. Pressed again, the button removes it. */
  pickRound(round: string): void {
    this.setRound(this.flight.peek().round === round ? '' : round);
  }

  setPlace(place: string): void {
    this.#change({ place });
  }

  setNote(note: string): void {
    this.#change({ note });
  }

  /** @param model null for none. */
  setModel(model: Model | null): void {
    this.#change({ model: model?.id ?? null, modelName: model?.name ?? '' });
  }

  /** Restores everything as it was when the form was opened. */
  undo(): void {
    this.#texts.value = new Map();
    const names = Object.keys(this.#changes.peek()) as (keyof Flight)[];
    // Fields that only another tab has changed stay.
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

  /** The pilot leaves the page: keeps what waits for the save in progress. */
  keepNow(): void {
    if (this.#waits) void this.#log.change(this.#opened.id, this.#changes.peek());
  }

  /** One save at a time: changes that come during a save wait for the next one. */
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
