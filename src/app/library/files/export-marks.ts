import { computed, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { loadSetting, saveSetting } from '../../browser/settings.js';
import type { Library } from '../../records/library.js';

const SETTING = 'library-exported';
const DAY = 86_400_000;
/** Fewer changes, or younger ones, are not worth a reminder. */
const ENOUGH = 5;
const LONG = 30 * DAY;

const date = v.nullable(v.pipe(v.number(), v.finite()));
const schema = v.object({ exportedAt: date, putOffAt: date });

/** When the whole library was last exported, and whether the next export is due. */
export class ExportMarks {
  /** How much has changed since the last one, or since the pilot put it off; null while no export is due. */
  readonly due: ReadonlySignal<number | null>;
  readonly #marks = signal(loadSetting(SETTING, schema) ?? { exportedAt: null, putOffAt: null });

  constructor(library: Pick<Library, 'models' | 'settings' | 'flights'>) {
    this.due = computed(() => {
      const { exportedAt, putOffAt } = this.#marks.value;
      const { models, settings, flights } = library;
      const records = [...models.list.value, ...settings.list.value, ...flights.list.value];
      const at = Date.now();
      // A mark in the future was made with a wrong clock. The clock of another device may be a little ahead.
      const isRight = (mark: number | null): mark is number => mark !== null && mark <= at + DAY;
      const since = Math.max(0, ...[exportedAt, putOffAt].filter(isRight));
      const changed = records.map(({ changedAt }) => changedAt).filter((changedAt) => changedAt > since);
      // Before the first export, counting begins with the first entry.
      const from = since || Math.min(...changed);
      return changed.length < ENOUGH || at - from < LONG ? null : changed.length;
    });
  }

  exported(at: number): void {
    this.#set({ exportedAt: at, putOffAt: null });
  }

  /** The pilot has read the reminder and does not want it again for a while. */
  putOff(): void {
    this.#set({ ...this.#marks.peek(), putOffAt: Date.now() });
  }

  #set(marks: v.InferOutput<typeof schema>): void {
    this.#marks.value = marks;
    saveSetting(SETTING, marks);
  }
}
