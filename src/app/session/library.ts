import { computed, type ReadonlySignal } from '@preact/signals';
import { type Flight, LIMITS, type Model, type Setting } from '../../program/index.js';
import type { TabChannel } from '../browser/other-tabs.js';
import type { FlightRecord, ModelRecord, SettingRecord, Storage } from '../storage/index.js';
import type { Clash } from './clashes.js';
import { Collection } from './collection.js';
import { beginningOf, withPlainNames } from './plain-names.js';

/** What the tabs say to each other when one of them has changed the library. */
const CHANGED = 'library changed';

/** A record on which two tabs do not agree, and in which list it is. */
export type LibraryClash =
  | ({ readonly kind: 'models' } & Clash<ModelRecord>)
  | ({ readonly kind: 'settings' } & Clash<SettingRecord>)
  | ({ readonly kind: 'flights' } & Clash<FlightRecord>);

/** A new record's id: it never comes twice, on this device or another. */
export function newId(): string {
  // Without https there is no crypto.randomUUID, and the page must work there too.
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** A model of which nothing but its name is known, and perhaps the class of its timer. */
export function emptyModel(id: string, name: string, timerClass: string | null): Model {
  return { id, name, timerClass, note: '', servos: [], memoryNames: [], photo: null, archived: false };
}

/** What a pilot keeps: models, their settings, and the log of flights. Without a timer, too; on this device alone. */
export class Library {
  readonly models: Collection<ModelRecord>;
  readonly settings: Collection<SettingRecord>;
  readonly flights: Collection<FlightRecord>;
  /** Whether all that was typed would be there after a reload. */
  readonly kept: ReadonlySignal<boolean>;
  /** Models or settings were asked for and not given: what is missing among them may be there. */
  readonly unread: ReadonlySignal<boolean>;
  /** Another tab has saved something else in the same place a moment before: the pilot has to choose. */
  readonly clash: ReadonlySignal<LibraryClash | null>;
  readonly #channel: TabChannel | null;

  /** @param channel between the tabs of this page, of the library alone; null where there is none. */
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

  /** Reads models and settings, unless that is done; the flights come when they are asked for. */
  async load(): Promise<void> {
    await Promise.all([this.models.load(), this.settings.load()]);
  }

  /** Reads again what has been read before. */
  async refresh(): Promise<void> {
    const read = [this.models, this.settings, this.flights].filter(({ loaded }) => loaded.peek());
    await Promise.all(read.map((each) => each.refresh()));
  }

  /** A new model, at the end of the list, or one that has changed. @returns its record. */
  async keepModel(model: Model, changes: Partial<ModelRecord> = {}): Promise<ModelRecord> {
    const before = this.models.get(model.id);
    const order = before?.order ?? nextOrder(this.models.list.peek());
    const verified = before?.verified ?? [];
    const record = { key: model.id, order, verified, ...changes, model: withPlainNames(model), changedAt: Date.now() };
    await this.models.save(record);
    return record;
  }

  /** What the servos of a model move. */
  async sayServos(id: string, servos: Model['servos']): Promise<void> {
    const model = this.models.get(id)?.model;
    if (model) await this.keepModel({ ...model, servos });
  }

  /** Takes a model out, and its settings with it; see {@link Collection.remove}. */
  removeModel(id: string): void {
    const settings = this.settings.list.peek().filter(({ setting }) => setting.model === id);
    this.models.remove(id);
    if (settings.length > 0) this.settings.remove(...settings.map(({ key }) => key));
  }

  /** Puts back what was taken out of the three lists, as long as it has not been deleted. */
  undoRemove(): void {
    for (const each of [this.models, this.settings, this.flights]) each.undoRemove();
  }

  /** A new setting, at the end of the list, or one that has changed. @returns its record. */
  async keepSetting(setting: Setting, changes: Partial<SettingRecord> = {}): Promise<SettingRecord> {
    const order = this.settings.get(setting.id)?.order ?? nextOrder(this.settings.list.peek());
    const record = { key: setting.id, order, ...changes, setting: withPlainNames(setting), changedAt: Date.now() };
    await this.settings.save(record);
    return record;
  }

  /** A new flight, or one that has changed. @returns its record. */
  async keepFlight(flight: Flight): Promise<FlightRecord> {
    const record = { key: flight.id, flight: withPlainNames(flight), changedAt: Date.now() };
    await this.flights.save(record);
    return record;
  }

  /**
   * Puts some models, or some settings, into another order among themselves.
   * @param keys all of them, in that order.
   */
  async arrange<T extends ModelRecord | SettingRecord>(list: Collection<T>, keys: readonly string[]): Promise<void> {
    const records = keys.flatMap((key) => list.get(key) ?? []);
    const places = records.map(({ order }) => order).sort((a, b) => a - b);
    // Two of one place would not keep their order.
    const steps = places.map((place, at) => (at > 0 && place <= (places[at - 1] as number) ? null : place));
    const isWhole = !steps.includes(null);
    const moved = records.flatMap((record, at) => {
      const order = isWhole ? (places[at] as number) : (places[0] as number) + at;
      return record.order === order ? [] : [{ ...record, order }];
    });
    if (moved.length > 0) await list.save(...moved);
  }

  /** The page is left: what was taken out is deleted. */
  flush(): void {
    for (const each of [this.models, this.settings, this.flights]) each.flush();
    this.keepClashes();
  }

  /** The page may not come back: what the pilot has not decided is there twice. */
  keepClashes(): void {
    for (const each of [this.models, this.settings, this.flights]) each.keepClashes();
  }

  /** The storage does again what it did not before: reads what it has not given back, keeps what it has not kept. */
  async keepAgain(): Promise<void> {
    const asked = [this.models, this.settings, this.flights].filter(({ loaded }) => loaded.peek());
    await Promise.all(asked.map((each) => each.load()));
    await Promise.all([this.models, this.settings, this.flights].map((each) => each.keepAgain()));
  }

  #tell(): void {
    try {
      this.#channel?.postMessage(CHANGED);
    } catch {
      // Nobody hears it: other tabs see it when they are opened next.
    }
  }
}

function nextOrder(records: readonly { readonly order: number }[]): number {
  return Math.max(0, ...records.map(({ order }) => order)) + 1;
}

/** The values of this tab beside those of another one. What its timers hold is known of one model alone. */
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
