import { computed, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { loadSetting, saveSetting } from '../../browser/settings.js';
import type { Library } from '../../records/library.js';

const SETTING = 'library-exported';
const DAY = 86_400_000;
/** Fewer changes, or younger ones, are not worth a reminder. */
const ENOUGH = 5;
const LONG = 30 * DAY;

/** When the whole library was last exported, and whether the next export is due. */
export class ExportMarks {
  /** How much has changed since the last one, or since the pilot put it off; null while no export is due. */
  readonly due: ReadonlySignal<number | null>;
  /** When it was last exported or put off; 0 for never. */
  readonly #mark = signal(loadSetting(SETTING, v.number()) ?? 0);

  constructor(library: Pick<Library, 'models' | 'settings' | 'flights'>) {
    this.due = computed(() => {
      const { models, settings, flights } = library;
      const records = [...models.list.value, ...settings.list.value, ...flights.list.value];
      const at = Date.now();
      // A mark in the future was made with a wrong clock. The clock of another device may be a little ahead.
      const since = this.#mark.value <= at + DAY ? this.#mark.value : 0;
      const changed = records.map(({ changedAt }) => changedAt).filter((changedAt) => changedAt > since);
      // Before the first export, counting begins with the first entry.
      const from = since || Math.min(...changed);
      return changed.length < ENOUGH || at - from < LONG ? null : changed.length;
    });
  }

  exported(at: number): void {
    this.#mark.value = at;
    saveSetting(SETTING, at);
  }

  /** The pilot has read the reminder and does not want it again for a while. */
  putOff(): void {
    this.exported(Date.now());
  }
}
