import { computed, effect, type ReadonlySignal, signal, untracked } from '@preact/signals';
import * as v from 'valibot';
import { differences, type Flight, LIMITS, requireFlight, sameLayout, type TimerProgram } from '../../program/index.js';
import { loadSetting, saveSetting } from '../browser/settings.js';
import { changesSince } from '../editing/content.js';
import { messages } from '../messages/index.js';
import { newId } from '../records/library.js';
import { beginningOf } from '../records/plain-names.js';
import { changeTime } from '../storage/collection.js';
import type { SettingRecord } from '../storage/index.js';
import type { Session } from '../work/session.js';
import { putBackDt } from '../write/put-back.js';
import type { WriteJob } from '../write/write-job.js';
import { type FlightFilter, NO_FILTER } from './flight-filter.js';
import { dayOf, deviceOffset } from './flight-list.js';

/** What was flown: the program, the model and the setting. */
type Flown = Pick<Flight, 'program' | 'model' | 'modelName' | 'setting' | 'settingName'>;

/** The setting that keeps the pilot's last place. */
const PLACE = 'flight-place';
const place = v.pipe(v.string(), v.maxLength(LIMITS.place));

/** What counts of a flight. Null takes back what was said. */
export interface FlightScore {
  readonly id: string;
  readonly maximum?: number | null;
  readonly counts?: boolean | null;
}

type LogParts = Pick<
  Session,
  'editor' | 'library' | 'onScreen' | 'opened' | 'origin' | 'reader' | 'runner' | 'shortDt' | 'standings'
>;

/**
 * Logs a flight with one tap, and changes flights. The view itself has the parts that only it needs: see
 * `flight-list.ts`.
 */
export class FlightLog {
  /** The program that flies next, by a fresh reading and without unwritten edits; null while it is not known. */
  readonly held: ReadonlySignal<TimerProgram | null>;
  /** The program that can be logged now: the one above, or under the result of a write what that write has verified. */
  readonly flyable: ReadonlySignal<TimerProgram | null>;
  /** The key of the flight that was last logged on this page; null once it was undone, or filled in. */
  readonly logged: ReadonlySignal<string | null>;
  /** The flight that is open in the form; null for none. */
  readonly filling: ReadonlySignal<string | null>;
  /** Which flights of the log are shown. Outlasts the view. */
  readonly filter: ReadonlySignal<FlightFilter>;
  readonly #filter = signal(NO_FILTER, { name: 'flightFilter' });
  readonly #logged = signal<string | null>(null, { name: 'logged' });
  /** What the write has verified whose result is shown. The timer may have been unplugged since. */
  readonly #verified = signal<Flown | null>(null, { name: 'verifiedFlown' });
  readonly #filling = signal<string | null>(null, { name: 'filling' });
  readonly #parts: LogParts;
  readonly #write: WriteJob;
  /** The flight for which DT is being put back: it will be flown with what that write leaves. */
  #puttingBack: string | null = null;

  constructor(parts: LogParts, write: WriteJob) {
    this.#parts = parts;
    this.#write = write;
    this.logged = this.#logged;
    this.filling = this.#filling;
    this.filter = this.#filter;
    this.held = computed(() => {
      const { reader, standings } = parts;
      const { known, sure } = standings.next.value ?? {};
      return sure === 'now' && known?.state === 'read' && !reader.byteOrderOpen.value ? known.program : null;
    });
    this.flyable = computed(() => this.held.value ?? this.#verified.value?.program ?? null);
    effect(() => {
      const held = write.verified.value;
      const flown = held && untracked(() => this.#flown(held));
      this.#verified.value = flown;
      const key = this.#puttingBack;
      if (flown && key !== null) {
        const { program, setting, settingName } = flown;
        this.#puttingBack = null;
        // The pilot may have said in the meantime which model it is.
        void this.change(key, { program, setting, settingName });
      }
      // A flight that was logged before a write must not show under the result of the write.
      if (write.current.value?.step === 'review') this.#logged.value = null;
    });
  }

  /**
   * Logs a flight with what the timer holds.
   * @returns the key of the flight; null when it is not known what flies next.
   */
  flying(): string | null {
    const held = this.held.peek();
    const flown = held ? this.#flown(held) : this.#verified.peek();
    return flown && this.#add({ ...flown, place: this.#place() });
  }

  /** Logs one more flight of the same model with the same program: nobody has read its timer since. */
  flyAgain({ model, modelName, setting, settingName, program, place: where }: Flight): string {
    return this.#add({ model, modelName, setting, settingName, program, place: where });
  }

  /** The logged flight is no longer shown in the place of the button. */
  forgetLogged(): void {
    this.#logged.value = null;
  }

  /** Shows all flights of the log, or only those that these fields ask for. */
  showOnly(changes: Partial<FlightFilter> = {}): void {
    this.#filter.value = { ...NO_FILTER, ...changes };
  }

  /** Opens the form of a flight. */
  fillIn(key: string): void {
    this.#filling.value = key;
  }

  /** Closes the form. A flight that was open in it is no longer new: “Undo” would remove what was filled in, too. */
  close(): void {
    if (this.#filling.peek() === this.#logged.peek()) this.#logged.value = null;
    this.#filling.value = null;
  }

  /** Changes a flight, if it is in the log. */
  async change(key: string, changes: Partial<Flight>): Promise<void> {
    const { library } = this.#parts;
    const flight = library.flights.get(key)?.flight;
    if (!flight) return;
    // An old flight that is corrected does not say where the next one will be.
    const isOld = dayOf(flight) < dayOf(library.flights.list.peek()[0]?.flight ?? flight);
    if (changes.place !== undefined && !isOld) saveSetting(PLACE, changes.place);
    await library.keepFlight({ ...flight, ...changes });
  }

  /** Says what counts of several flights, in one step. */
  async score(scores: readonly FlightScore[]): Promise<void> {
    const { flights } = this.#parts.library;
    const changed = scores.flatMap((score) => {
      const before = flights.get(score.id);
      return before
        ? { ...before, flight: requireFlight({ ...before.flight, ...score }), changedAt: changeTime(before) }
        : [];
    });
    await flights.save(...changed);
  }

  /** Removes a flight from the log. Can be undone for some seconds. */
  remove(key: string): void {
    if (this.#filling.peek() === key) this.close();
    if (this.#logged.peek() === key) this.#logged.value = null;
    this.#parts.library.flights.remove(key);
  }

  /**
   * Shows the program of a flight as it was then: the setting that it was flown with, if that still is exactly this,
   * else its copy, as a backup of its model. Unsaved changes of that setting are one step back.
   * @returns whether it is shown.
   */
  async showFlown({ program, model, setting }: Flight): Promise<boolean> {
    const { library, opened, onScreen } = this.#parts;
    await library.load();
    const saved = library.settings.get(setting)?.setting;
    if (saved && isExactly(saved.program, program)) {
      if (!(await opened.show(saved))) return false;
      const { changes = 0, unreadable = 0 } = opened.unsaved.peek() ?? {};
      if (changes + unreadable > 0) opened.loadAgain();
    } else {
      if (opened.obstacle(program)) return false;
      onScreen.showBackup({ program, ...(model !== null && { model }) });
    }
    return true;
  }

  /** Whether DT can be put back for a flight: it is not flown yet, and the timer still holds its program. */
  canPutBack({ program, result }: Flight): boolean {
    const held = this.held.value;
    const { shortDt, runner, editor } = this.#parts;
    if (!held || !shortDt.held.value || result !== null || !runner.ready.value || editor.blocked.value) return false;
    return isExactly(held, program);
  }

  /** Puts DT back by a write that the pilot confirms first. Once verified, the flight gets that program. */
  async putBack(key: string): Promise<void> {
    this.close();
    this.#puttingBack = key;
    await putBackDt(this.#parts, this.#write);
    this.#puttingBack = null;
  }

  /** What flies is what the timer was last read to hold. It is of a setting only where each value is. */
  #flown(program: TimerProgram): Flown {
    const { origin, library, editor, onScreen } = this.#parts;
    const isSame = ({ setting }: SettingRecord): boolean =>
      sameLayout(setting.program.identity, program.identity) && changesSince(setting.program, program).length === 0;
    // What is on the screen may be of another memory.
    const held = onScreen.apart.peek() ? null : editor.heldOf.peek().of;
    const from = library.settings.get(held?.id ?? null);
    const model = origin.timer.peek() ?? library.models.get(from?.setting.model ?? null)?.model ?? null;
    const isOwn = ({ setting }: SettingRecord): boolean => setting.model === (model?.id ?? null);
    const [only, ...more] = library.settings.list.peek().filter((record) => isOwn(record) && isSame(record));
    const exact = from && isOwn(from) && isSame(from) ? from : more.length === 0 ? only : undefined;
    return {
      model: model?.id ?? null,
      modelName: model?.name ?? '',
      setting: exact?.key ?? null,
      settingName: exact?.setting.name ?? (from ? this.#likeName(from, isOwn(from), isSame(from)) : ''),
      program,
    };
  }

  /** A name for what is no setting of the model that flies: “calm, changed”, or the setting of another model. */
  #likeName({ setting }: SettingRecord, isOwn: boolean, isSame: boolean): string {
    const { knowledge } = messages.value;
    const other = isOwn ? undefined : this.#parts.library.models.get(setting.model)?.model.name;
    const end = isSame ? '' : knowledge.changed({ name: '' });
    const name = other === undefined ? setting.name : knowledge.ofModel({ name: setting.name, model: other });
    return beginningOf(name, LIMITS.name - end.length) + end;
  }

  #add(flight: Flown & Pick<Flight, 'place'>): string {
    const key = newId();
    const nothingNoted = { wind: null, temperature: null, round: '', result: null, note: '' };
    const { library } = this.#parts;
    this.#logged.value = key;
    const at = Date.now();
    void library.keepFlight({ id: key, at, utcOffset: deviceOffset(at), ...nothingNoted, ...flight });
    return key;
  }

  #place(): string {
    return loadSetting(PLACE, place) ?? this.#parts.library.flights.list.peek()[0]?.flight.place ?? '';
  }
}

function isExactly(one: TimerProgram, other: TimerProgram): boolean {
  return sameLayout(one.identity, other.identity) && differences(one, other).length === 0;
}
