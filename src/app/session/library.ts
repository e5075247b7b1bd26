import { computed, type ReadonlySignal } from '@preact/signals';
import { type Flight, LIMITS, type Model, type Setting } from '../../program/index.js';
import type { TabChannel } from '../browser/other-tabs.js';
import type { FlightRecord, ModelRecord, SettingRecord, Storage } from '../storage/index.js';
import type { Clash } from './clashes.js';
import { Collection, changeTime } from './collection.js';
import { beginningOf, withPlainNames } from './plain-names.js';

/** The message between tabs when one of them has changed the library. */
const CHANGED = 'library changed';

/** A record on which two tabs do not agree, and the list that it is in. */
export type LibraryClash =
  | ({ readonly kind: 'models' } & Clash<ModelRecord>)
  | ({ readonly kind: 'settings' } & Clash<SettingRecord>)
  | ({ readonly kind: 'flights' } & Clash<FlightRecord>);

/** The id of a new record. It never comes twice, on any device. */
export function newId(): string {
  // Without https there is no crypto.randomUUID, but the page must work all the same.
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** A model of which only the name is known, and perhaps the class of its timer. */
export function emptyModel(id: string, name: string, timerClass: string | null): Model {
  return { id, name, timerClass, note: '', servos: [], memoryNames: [], photo: null, archived: false };
}

/** What a pilot keeps: models, their settings, and the log of flights. Works without a timer. Stays on this device. */
export class Library {
  readonly models: Collection<ModelRecord>;
  readonly settings: Collection<SettingRecord>;
  readonly flights: Collection<FlightRecord>;
  /** Whether everything that was typed would survive a reload. */
  readonly kept: ReadonlySignal<boolean>;
  /** Whether the storage failed to give models or settings: missing ones may be there. */
  readonly unread: ReadonlySignal<boolean>;
  /** Set when another tab has just saved something else in the same place: the pilot has to choose. */
  readonly clash: ReadonlySignal<LibraryClash | null>;
  readonly #channel: TabChannel | null;

  /** @param channel between the tabs of this page, for the library only; null when there is none. */
  constructor(storage: Pick<Storage, 'models' | 'settings' | 'flights'>, channel: TabChannel | null = null) {
    const byOrder = (a: { order: number; key: string }, b: { order: number; key: string }): number =>
      a.order - b.order || (a.key < b.key ? -1 : 1);
    const latestFirst = (a: FlightRecord, b: FlightRecord): number =>
      b.flight.at - a.flight.at || (a.key < b.key ? -1 : 1);
    const tell = (): void => this.#tell();
    this.models = new Collection(storage.models, byOrder, copyOfModel, tell);
    this.settings = new Collection(storage.settings, byOrder, copyOfSetting, tell);
    this.flights = new Collection(storage.flights, latestFirst, copyOfFlight, tell);
    this.kept = computed(() =>
      [this.models, this.settings, this.flights].every(({ unsaved }) => unsaved.value.size === 0),
    );
    this.unread = computed(() => this.models.failed.value || this.settings.failed.value);
    this.clash = computed(() => {
      const [model] = this.models.clashes.value;
      const [setting] = this.settings.clashes.value;
      const [flight] = this.flights.clashes.value;
      if (model) return { kind: 'models', ...model };
      if (setting) return { kind: 'settings', ...setting };
      return flight ? { kind: 'flights', ...flight } : null;
    });
    this.#channel = channel;
    channel?.addEventListener('message', ({ data }) => {
      if (data === CHANGED) void this.refresh();
    });
  }

  /** Reads models and settings, unless that is done. Flights are read when they are needed. */
  async load(): Promise<void> {
    await Promise.all([this.models.load(), this.settings.load()]);
  }

  /** Reads everything again that was read before. */
  async refresh(): Promise<void> {
    const read = [this.models, this.settings, this.flights].filter(({ loaded }) => loaded.peek());
    await Promise.all(read.map((each) => each.refresh()));
  }

  /** Saves a new model at the end of the list, or a changed one. @returns its record. */
  async keepModel(model: Model, changes: Partial<ModelRecord> = {}): Promise<ModelRecord> {
    const before = this.models.get(model.id);
    const order = before?.order ?? nextOrder(this.models.list.peek());
    const verified = before?.verified ?? [];
    const changedAt = changeTime(before);
    const record = { key: model.id, order, verified, ...changes, model: withPlainNames(model), changedAt };
    await this.models.save(record);
    return record;
  }

  /** What the servos of a model move. */
  async sayServos(id: string, servos: Model['servos']): Promise<void> {
    const model = this.models.get(id)?.model;
    if (model) await this.keepModel({ ...model, servos });
  }

  /** Removes a model with its settings; see {@link Collection.remove}. */
  removeModel(id: string): void {
    const settings = this.settings.list.peek().filter(({ setting }) => setting.model === id);
    this.models.remove(id);
    if (settings.length > 0) this.settings.remove(...settings.map(({ key }) => key));
  }

  /** Puts back what was removed from the three lists, if it is not deleted yet. */
  undoRemove(): void {
    for (const each of [this.models, this.settings, this.flights]) each.undoRemove();
  }

  /** Saves a new setting at the end of the list, or a changed one. @returns its record. */
  async keepSetting(setting: Setting): Promise<SettingRecord> {
    const before = this.settings.get(setting.id);
    const order = before?.order ?? nextOrder(this.settings.list.peek());
    const changedAt = changeTime(before);
    const record = { key: setting.id, order, setting: withPlainNames(setting), changedAt };
    await this.settings.save(record);
    return record;
  }

  /** Saves a new flight, or a changed one. @returns its record. */
  async keepFlight(flight: Flight): Promise<FlightRecord> {
    const changedAt = changeTime(this.flights.get(flight.id));
    const record = { key: flight.id, flight: withPlainNames(flight), changedAt };
    await this.flights.save(record);
    return record;
  }

  /**
   * Puts some models, or some settings, into another order.
   * @param keys their keys in the new order.
   */
  async arrange<T extends ModelRecord | SettingRecord>(list: Collection<T>, keys: readonly string[]): Promise<void> {
    const records = keys.flatMap((key) => list.get(key) ?? []);
    const places = records.map(({ order }) => order).sort((a, b) => a - b);
    // Two records with the same place would not keep their order.
    const steps = places.map((place, at) => (at > 0 && place <= (places[at - 1] as number) ? null : place));
    const isWhole = !steps.includes(null);
    const moved = records.flatMap((record, at) => {
      const order = isWhole ? (places[at] as number) : (places[0] as number) + at;
      return record.order === order ? [] : [{ ...record, order }];
    });
    if (moved.length > 0) await list.save(...moved);
  }

  /** The pilot leaves the page: deletes what was removed. */
  flush(): void {
    for (const each of [this.models, this.settings, this.flights]) each.flush();
    this.keepClashes();
  }

  /** The page may not come back: keeps both versions of records on which the pilot has not chosen. */
  keepClashes(): void {
    for (const each of [this.models, this.settings, this.flights]) each.keepClashes();
  }

  /** The storage works again: reads what it did not give, and saves what it did not save. */
  async keepAgain(): Promise<void> {
    const asked = [this.models, this.settings, this.flights].filter(({ loaded }) => loaded.peek());
    await Promise.all(asked.map((each) => each.load()));
    await Promise.all([this.models, this.settings, this.flights].map((each) => each.keepAgain()));
  }

  #tell(): void {
    try {
      this.#channel?.postMessage(CHANGED);
    } catch {
      // Nobody hears it: other tabs will see the change when they open next.
    }
  }
}

function nextOrder(records: readonly { readonly order: number }[]): number {
  return Math.max(0, ...records.map(({ order }) => order)) + 1;
}

/** The values of this tab as a copy beside those of another one. Only one model keeps what its timer holds. */
function copyOfModel({ model, ...rest }: ModelRecord): ModelRecord {
  const key = newId();
  return { ...rest, key, verified: [], model: { ...model, id: key, name: secondName(model.name) } };
}

function copyOfSetting({ setting, ...rest }: SettingRecord): SettingRecord {
  const key = newId();
  return { ...rest, key, setting: { ...setting, id: key, name: secondName(setting.name) } };
}

function copyOfFlight({ flight, ...rest }: FlightRecord): FlightRecord {
  const key = newId();
  return { ...rest, key, flight: { ...flight, id: key } };
}

function secondName(name: string): string {
  const end = ' (2)';
  return beginningOf(name, LIMITS.name - end.length) + end;
}
