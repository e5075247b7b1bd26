import { batch, computed, effect, type ReadonlySignal, signal, untracked } from '@preact/signals';
import * as v from 'valibot';
import { differences, type Flight, LIMITS, sameLayout, type TimerProgram } from '../../program/index.js';
import { loadSetting, saveSetting } from '../browser/settings.js';
import { newId } from '../session/library.js';
import type { Session } from '../session/session.js';
import { putBackDt } from '../write/put-back.js';
import type { WriteFlow } from '../write/write-flow.js';
import { type FlightFilter, NO_FILTER } from './flight-filter.js';

/** What is flown, and by which model with which setting. */
type Flown = Pick<Flight, 'program' | 'model' | 'modelName' | 'setting' | 'settingName'>;

/** The place where the pilot was last. */
const PLACE = 'flight-place';
const place = v.pipe(v.string(), v.maxLength(LIMITS.place));

/**
 * What is logged with one tap, and what can be done with a flight. What of the log is shown, and how a flight is
 * filled in, comes with its view: see `flight-list.ts` and `FlightForm`.
 */
export class FlightLog {
  /** What flies next by a fresh reading, never what is merely typed; null while that is not known. */
  readonly held: ReadonlySignal<TimerProgram | null>;
  /** What can be logged now: what is held; under the result of a write also what that has verified. */
  readonly flyable: ReadonlySignal<TimerProgram | null>;
  /** The flight that was logged last on this page, by its key; null once it was undone. */
  readonly logged: ReadonlySignal<string | null>;
  /** The browser was asked to keep that flight, and did not. */
  readonly unkept: ReadonlySignal<boolean>;
  /** The flight that is filled in; null while none is. */
  readonly filling: ReadonlySignal<string | null>;
  /** What of the log is shown: it outlasts the view. */
  readonly filter: ReadonlySignal<FlightFilter>;
  readonly #filter = signal(NO_FILTER, { name: 'flightFilter' });
  readonly #logged = signal<string | null>(null, { name: 'logged' });
  readonly #unkept = signal(false, { name: 'flightUnkept' });
  /** By the write whose result is shown: the timer may have been unplugged since. */
  readonly #verified = signal<Flown | null>(null, { name: 'verifiedFlown' });
  readonly #filling = signal<string | null>(null, { name: 'filling' });
  readonly #session: Session;
  readonly #write: WriteFlow;
  /** The flight for which DT is put back: it is flown with what that write leaves. */
  #puttingBack: string | null = null;

  constructor(session: Session, write: WriteFlow) {
    this.#session = session;
    this.#write = write;
    this.logged = this.#logged;
    this.unkept = this.#unkept;
    this.filling = this.#filling;
    this.filter = this.#filter;
    this.held = computed(() => {
      const { standing, nextFlight, byteOrderOpen, knowledge, editor } = session;
      if (standing.value.sure !== 'now' || nextFlight.open.value || byteOrderOpen.value) return null;
      const known = knowledge.of(editor.working.value?.memory ?? null);
      return known.state === 'read' ? known.program : null;
    });
    this.flyable = computed(() => this.held.value ?? this.#verified.value?.program ?? null);
    effect(() => {
      const step = write.current.value;
      const held = step?.step === 'done' && step.report.result === 'verified' ? step.report.held : null;
      this.#verified.value = held && untracked(() => this.#flown(held));
      if (held && this.#puttingBack !== null) void this.change(this.#puttingBack, { program: held });
      if (held || step === null) this.#puttingBack = null;
      // What was logged before a write is not said under its result, as if that were logged.
      if (step?.step === 'review') this.#logged.value = null;
    });
  }

  /**
   * What the timer holds is flown now.
   * @returns the key of the flight; null where it is not known what flies next.
   */
  flying(): string | null {
    const held = this.held.peek();
    const flown = held ? this.#flown(held) : this.#verified.peek();
    return flown && this.#add({ ...flown, place: this.#place() });
  }

  /** The same model is flown once more, as it was: nobody has read its timer since. */
  flyAgain({ model, modelName, setting, settingName, program, place: where }: Flight): string {
    return this.#add({ model, modelName, setting, settingName, program, place: where });
  }

  /** Takes the flight that was logged last out of the log. */
  undo(): void {
    const key = this.#logged.peek();
    if (key === null) return;
    this.remove(key);
    this.#logged.value = null;
  }

  /** The result of a write was left: what was logged there is said no longer. */
  forgetLogged(): void {
    this.#logged.value = null;
  }

  /** Narrows or widens what of the log is shown. */
  narrow(changes: Partial<FlightFilter>): void {
    this.#filter.value = { ...this.#filter.peek(), ...changes };
  }

  /** Shows all flights of the log, or no others than these. */
  showOnly(changes: Partial<FlightFilter> = {}): void {
    this.#filter.value = { ...NO_FILTER, ...changes };
  }

  /** Opens a flight to be filled in. */
  fillIn(key: string): void {
    this.#filling.value = key;
  }

  close(): void {
    this.#filling.value = null;
  }

  /**
   * Changes a flight in the log.
   * @returns whether the browser keeps it; also true where there is no such flight.
   */
  async change(key: string, changes: Partial<Flight>): Promise<boolean> {
    const { library } = this.#session;
    const record = library.flights.get(key);
    if (!record) return true;
    if (changes.place !== undefined) saveSetting(PLACE, changes.place);
    const kept = await library.keepFlight({ ...record.flight, ...changes });
    return !library.flights.unsaved.peek().has(kept.key);
  }

  /** Takes a flight out of the log; for some seconds that can be undone. */
  remove(key: string): void {
    if (this.#filling.peek() === key) this.close();
    if (this.#logged.peek() === key) this.#logged.value = null;
    this.#session.library.flights.remove(key);
  }

  /** Whether DT can be put back for a flight: it was not flown yet, and the timer holds what it says. */
  canPutBack({ program, result }: Flight): boolean {
    const held = this.held.value;
    const { shortDt, runner, editor } = this.#session;
    if (!held || !shortDt.held.value || result !== null || !runner.ready.value || editor.blocked.value) return false;
    return sameLayout(held.identity, program.identity) && differences(held, program).length === 0;
  }

  /** Puts DT back by a write that is shown first. When that is verified, it is what the flight is flown with. */
  async putBack(key: string): Promise<void> {
    this.close();
    this.#puttingBack = (await putBackDt(this.#session, this.#write)) ? key : null;
  }

  #flown(program: TimerProgram): Flown {
    const { modelAtHand, opened, editor } = this.#session;
    // What is on the screen and not in the timer belongs to some setting, too: that one is not flown.
    const shown = editor.changes.peek().length === 0 ? opened.shown.peek() : null;
    const setting = shown?.setting;
    const model = modelAtHand.peek() ?? shown?.model;
    return {
      model: model?.id ?? null,
      modelName: model?.name ?? '',
      setting: setting?.id ?? null,
      settingName: setting?.name ?? '',
      program,
    };
  }

  #add(flight: Flown & Pick<Flight, 'place'>): string {
    const key = newId();
    const nothingNoted = { wind: null, temperature: null, round: '', result: null, note: '' };
    const { library } = this.#session;
    batch(() => {
      this.#logged.value = key;
      this.#unkept.value = false;
    });
    void library.keepFlight({ id: key, at: Date.now(), ...nothingNoted, ...flight }).then(() => {
      if (this.#logged.peek() === key) this.#unkept.value = library.flights.unsaved.peek().has(key);
    });
    return key;
  }

  #place(): string {
    return loadSetting(PLACE, place) ?? this.#session.library.flights.list.peek()[0]?.flight.place ?? '';
  }
}
