import { batch, computed, type ReadonlySignal } from '@preact/signals';
import type { Flight, Model, Setting } from '../../program/index.js';
import { language } from '../messages/language.js';
import { byKey, Collection, changeTime } from '../storage/collection.js';
import type { FlightRecord, LibraryChange, ModelRecord, SettingRecord, Storage } from '../storage/index.js';
import { withPlainNames } from './plain-names.js';
import { versionsAfter } from './versions.js';

/** The id of a new record. It never comes twice, on any device. */
export function newId(): string {
  // Without https there is no crypto.randomUUID, but the page must work all the same.
  const bytes = crypto.getRandomValues(new Uint8Array(16));
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** A model of which only the name is known, and perhaps the class of its timer. */
export function emptyModel(id: string, name: string, timerClass: string | null): Model {
  return { id, name, timerClass, note: '', servos: [], memoryNames: [], archived: false };
}

/** By name, as the language of the page sorts. */
const byName = computed(() => new Intl.Collator(language.value, { numeric: true }).compare);

/**
 * What a pilot keeps: models, their settings, and the log of flights. Works without a timer. Stays on this device.
 * Models stand by name; settings and flights by date, the latest first.
 */
export class Library {
  readonly models: Collection<ModelRecord>;
  readonly settings: Collection<SettingRecord>;
  readonly flights: Collection<FlightRecord>;
  /** Whether everything that was typed would survive a reload. */
  readonly kept: ReadonlySignal<boolean>;
  /** Whether the storage failed to give models or settings: missing ones may be there. */
  readonly unread: ReadonlySignal<boolean>;
  readonly #storage: LibraryStorage;

  constructor(storage: LibraryStorage) {
    this.#storage = storage;
    const later = { flush: () => this.flush() };
    this.models = new Collection({
      inOrder: (a, b) => byName.value(a.model.name, b.model.name) || byKey(a, b),
      keeper: storage.models,
      change: (models) => this.change({ models }),
      later,
    });
    this.settings = new Collection({
      inOrder: (a, b) => b.setting.at - a.setting.at || byKey(a, b),
      keeper: storage.settings,
      change: (settings) => this.change({ settings }),
      later,
    });
    this.flights = new Collection({
      inOrder: (a, b) => b.flight.at - a.flight.at || byKey(a, b),
      keeper: storage.flights,
      change: (flights) => this.change({ flights }),
      later,
    });
    this.kept = computed(() =>
      [this.models, this.settings, this.flights].every(({ unsaved }) => unsaved.value.size === 0),
    );
    this.unread = computed(() => this.models.failed.value || this.settings.failed.value);
  }

  /** Reads models and settings, unless that is done. Flights are read when they are needed. */
  async load(): Promise<void> {
    await Promise.all([this.models.load(), this.settings.load()]);
  }

  /**
   * Changes records that belong together. They are on the screen at once, and in the storage all or none of them.
   * @returns whether the storage has all of it.
   */
  async change(change: LibraryChange): Promise<boolean> {
    const { models = {}, settings = {}, flights = {} } = change;
    // Without a word to the storage: its answer would say that it works, and all that waits would be tried again.
    if ([models, settings, flights].every(({ put = [], gone = [] }) => put.length + gone.length === 0)) return true;
    batch(() => {
      this.models.begin(models);
      this.settings.begin(settings);
      this.flights.begin(flights);
    });
    const isKept = await this.#storage.change(change).then(
      () => true,
      () => false,
    );
    if (!isKept) return false;
    batch(() => {
      this.models.ended(models);
      this.settings.ended(settings);
      this.flights.ended(flights);
    });
    return true;
  }

  /** Saves a new model, or a changed one. */
  async keepModel(model: Model, changes: Partial<ModelRecord> = {}): Promise<void> {
    const before = this.models.get(model.id);
    const verified = before?.verified ?? [];
    const changedAt = changeTime(before);
    await this.models.save({ key: model.id, verified, ...changes, model: withPlainNames(model), changedAt });
  }

  /** Changes facts of a model as it is now: a field saves its text late, perhaps when the model was deleted. */
  async changeModel(id: string, changed: Partial<Model>): Promise<void> {
    const model = this.models.get(id)?.model;
    if (model) await this.keepModel({ ...model, ...changed });
  }

  /** Removes a model with its settings; see {@link Collection.remove}. What it holds is deleted before it. */
  removeModel(id: string): void {
    const settings = this.settings.list.peek().filter(({ setting }) => setting.model === id);
    if (settings.length > 0) this.settings.remove(...settings.map(({ key }) => key));
    this.models.remove(id);
  }

  /** Puts back what was removed from the three lists, if it is not deleted yet. */
  undoRemove(): void {
    for (const each of [this.models, this.settings, this.flights]) each.undoRemove();
  }

  /** Saves a new setting, or a changed one, whose values before stay as a version. */
  async keepSetting(setting: Setting, changes: Partial<SettingRecord> = {}): Promise<void> {
    const before = this.settings.get(setting.id);
    const changedAt = changeTime(before);
    const versions = versionsAfter(before, setting.program, changedAt);
    await this.settings.save({ key: setting.id, versions, ...changes, setting: withPlainNames(setting), changedAt });
  }

  /** Saves a new flight, or a changed one. */
  async keepFlight(flight: Flight): Promise<void> {
    const changedAt = changeTime(this.flights.get(flight.id));
    await this.flights.save({ key: flight.id, flight: withPlainNames(flight), changedAt });
  }

  /** Deletes for good what was removed, in one step; see {@link Collection.flush}. */
  flush(): void {
    const gone = ({ removed }: { removed: ReadonlySignal<readonly { readonly key: string }[]> }) => ({
      gone: removed.peek().map(({ key }) => key),
    });
    void this.change({ flights: gone(this.flights), settings: gone(this.settings), models: gone(this.models) });
  }

  /** The storage works again: reads what it did not give, and does what it did not do. */
  async keepAgain(): Promise<void> {
    const { models, settings, flights } = this;
    await Promise.all([models, settings, flights].map(async (each) => each.loaded.peek() && (await each.load())));
    await this.change({ models: models.waiting, settings: settings.waiting, flights: flights.waiting });
  }
}

type LibraryStorage = Pick<Storage, 'models' | 'settings' | 'flights' | 'change'>;
