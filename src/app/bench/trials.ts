import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { type Change, differences, fieldKey, sameLayout, type TimerProgram } from '../../program/index.js';
import { loadSetting, saveSetting } from '../browser/settings.js';
import type { FieldValue } from '../editing/edit.js';
import { trialsSchema } from '../storage/records.js';

/** What was tried while the servos followed. */
export interface Trial {
  /** What the timer held before, by a fresh read; it is among the backups. */
  readonly before: TimerProgram;
  /** The keys of the positions that were sent to the timer since. */
  readonly touched: ReadonlySet<string>;
}

/** Under which name the trials are kept. */
const TRIALS = 'trials';

/**
 * What was tried on the bench and is neither kept nor put back: for each memory of each timer that was worked on,
 * through a reload too.
 */
export class Trials {
  /** Of what the timer at hand holds; null when nothing is open there. */
  readonly current: ReadonlySignal<Trial | null>;
  /** The positions that the timer holds otherwise than before. */
  readonly tried: ReadonlySignal<readonly Change[]>;
  readonly #trials = signal<ReadonlyMap<string, Trial>>(kept() ?? new Map(), { name: 'trials' });
  readonly #held: ReadonlySignal<TimerProgram | null>;
  readonly #keyOf: (program: TimerProgram) => string;

  /**
   * @param held what the timer at hand holds.
   * @param keyOf under what the work on a program is kept.
   */
  constructor(held: ReadonlySignal<TimerProgram | null>, keyOf: (program: TimerProgram) => string) {
    this.#held = held;
    this.#keyOf = keyOf;
    this.current = computed(() => {
      const trial = held.value && this.#trials.value.get(keyOf(held.value));
      // What was kept may be damaged.
      return trial && held.value && sameLayout(trial.before.identity, held.value.identity) ? trial : null;
    });
    this.tried = computed(() => {
      const trial = this.current.value;
      if (!trial || !held.value) return [];
      return differences(trial.before, held.value).filter(({ field }) => trial.touched.has(fieldKey(field)));
    });
  }

  /** The values that bring back what the timer held before. */
  takeBack(): readonly FieldValue[] {
    return this.tried.value.flatMap(({ field, from }) => (from === null ? [] : [{ field, value: from }]));
  }

  /** Keeps the trial of what the timer holds now, or ends it. */
  set(trial: Trial | null): void {
    const held = this.#held.peek();
    if (!held) return;
    // Other tabs keep theirs in the same place.
    const trials = new Map(kept() ?? this.#trials.peek());
    if (trial) trials.set(this.#keyOf(held), trial);
    else trials.delete(this.#keyOf(held));
    this.#trials.value = trials;
    saveSetting(
      TRIALS,
      [...trials].map(([key, { before, touched }]) => ({ key, before, touched: [...touched] })),
    );
  }
}

/** Null where nothing is kept. */
function kept(): ReadonlyMap<string, Trial> | null {
  const trials = loadSetting(TRIALS, trialsSchema);
  return trials && new Map(trials.map(({ key, before, touched }) => [key, { before, touched: new Set(touched) }]));
}
