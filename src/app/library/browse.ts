import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { foldedOf, foldedText, searchFor } from '../messages/search.js';
import type { Library } from '../records/library.js';
import type { ModelRecord, SettingRecord } from '../storage/index.js';

/** How many of the settings that were changed last are shown. */
const LATEST = 12;

/** What the pilot looks at in the library. Outlasts the view. */
export class Browse {
  readonly #text = signal('');
  readonly #archive = signal(false);
  /** The text to search for. Empty: no search. */
  readonly text: ReadonlySignal<string> = this.#text;
  /** Whether archived models are shown, too. */
  readonly archive: ReadonlySignal<boolean> = this.#archive;
  /** The settings of each model, by its id; those of no model under null. */
  readonly byModel: ReadonlySignal<ReadonlyMap<string | null, readonly SettingRecord[]>>;
  /** The settings that the search finds; null without a search. */
  readonly found: ReadonlySignal<readonly SettingRecord[] | null>;
  /** The settings that were changed last, of all models that are shown. */
  readonly latest: ReadonlySignal<readonly SettingRecord[]>;
  /** The models that are shown. */
  readonly models: ReadonlySignal<readonly ModelRecord[]>;
  readonly #textOf = foldedOf<SettingRecord>(({ setting: { name, note, tags } }) => [name, note, ...tags]);

  constructor({ models, settings }: Pick<Library, 'models' | 'settings'>) {
    this.byModel = computed(() => {
      const known = new Set(models.list.value.map(({ key }) => key));
      const map = new Map<string | null, SettingRecord[]>();
      for (const record of settings.list.value) {
        // A setting stays visible when its model is gone.
        const model = record.setting.model !== null && known.has(record.setting.model) ? record.setting.model : null;
        const list = map.get(model);
        if (list) list.push(record);
        else map.set(model, [record]);
      }
      return map;
    });
    this.models = computed(() => models.list.value.filter(({ model }) => this.#archive.value || !model.archived));
    this.latest = computed(() =>
      settings.list.value
        .filter(({ setting }) => this.#archive.value || !models.get(setting.model)?.model.archived)
        .sort((one, other) => other.changedAt - one.changedAt)
        .slice(0, LATEST),
    );
    this.found = computed(() => {
      if (this.#text.value.trim() === '') return null;
      const isFound = searchFor(this.#text.value);
      const names = new Map(models.list.value.map(({ key, model }) => [key, foldedText(model.name)]));
      return settings.list.value.filter((record) =>
        isFound(`${this.#textOf(record)}\n${names.get(record.setting.model ?? '') ?? ''}`),
      );
    });
  }

  search(text: string): void {
    this.#text.value = text;
  }

  showArchive(shown: boolean): void {
    this.#archive.value = shown;
  }
}
