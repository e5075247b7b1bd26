import { computed, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { loadSetting, saveSetting } from '../../browser/settings.js';
import type { Library } from '../../session/library.js';

/** It is time for an export: so much has changed since the last one, or since it was put off. */
export interface ExportDue {
  readonly changes: number;
  /** Days since the last export; null when there was none. */
  readonly days: number | null;
}

const SETTING = 'library-exported';
const DAY = 86_400_000;
/** Fewer changes than these, or younger ones, are not worth a word. */
const ENOUGH = 5;
const LONG = 30 * DAY;

const date = v.nullable(v.pipe(v.number(), v.finite()));
const schema = v.object({ exportedAt: date, putOffAt: date });

/** When all of the library was exported last, and whether it is time to say that it should be again. */
export class ExportMarks {
  /** Null while there is nothing to say. */
  readonly due: ReadonlySignal<ExportDue | null>;
  readonly #marks = signal(loadSetting(SETTING, schema) ?? { exportedAt: null, putOffAt: null });

  /** @param now in milliseconds since 1970; it is asked when something has changed. */
  constructor(library: Pick<Library, 'models' | 'settings' | 'flights'>, now: () => number = Date.now) {
    this.due = computed(() => {
      const { exportedAt, putOffAt } = this.#marks.value;
      const records = [library.models, library.settings, library.flights].flatMap(
        ({ list }): readonly { changedAt: number }[] => list.value,
      );
      const at = now();
      // One of the future was made while the clock of a device was wrong; that of another may go ahead a little.
      const isRight = (mark: number | null): mark is number => mark !== null && mark <= at + DAY;
      const since = Math.max(0, ...[exportedAt, putOffAt].filter(isRight));
      const changed = records.filter(({ changedAt }) => changedAt > since).map(({ changedAt }) => changedAt);
      if (changed.length < ENOUGH) return null;
      // Before any export the first entry is as good a beginning.
      const from = since || Math.min(...changed);
      if (at - from < LONG) return null;
      return { changes: changed.length, days: isRight(exportedAt) ? Math.floor((at - exportedAt) / DAY) : null };
    });
  }

  exported(at: number): void {
    this.#set({ exportedAt: at, putOffAt: null });
  }

  /** The pilot has read it, and does not want to hear of it for a while. */
  putOff(): void {
    this.#set({ ...this.#marks.peek(), putOffAt: Date.now() });
  }

  #set(marks: v.InferOutput<typeof schema>): void {
    this.#marks.value = marks;
    saveSetting(SETTING, marks);
  }
}
