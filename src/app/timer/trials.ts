import { computed, type ReadonlySignal, signal } from '@preact/signals';
import { type Change, differences, fieldKey, sameLayout, type TimerProgram } from '../../program/index.js';
import { loadSetting, saveSetting } from '../browser/settings.js';
import type { FieldValue } from '../editing/edit.js';
import { trialsSchema } from '../storage/records.js';
import { isSimulated } from './knowledge.js';
import { programKey } from './record-keys.js';

/** Positions that were tried while the servos followed. */
export interface Trial {
  /** What the timer held before, by a fresh read. It is among the backups, too. */
  readonly before: TimerProgram;
  /** The keys of the positions that were sent to the timer since then. */
  readonly touched: ReadonlySet<string>;
}

/** A trial that is over, and neither kept nor put back. */
export interface OpenTrial extends Trial {
  /** The kind of timer and the memory: see `programKey`. */
  readonly key: string;
}

/** The name under which the browser keeps the trials. */
const TRIALS = 'trials';

/**
 * Positions that were tried on the bench and neither kept nor put back: for each memory of each timer that was worked
 * on, also after a reload.
 */
export class Trials {
  /** All of them that wait for the pilot's word, of every timer that this browser knows. */
  readonly open: ReadonlySignal<readonly OpenTrial[]>;
  /** The trial for the present content of the timer; null when none is open. */
  readonly current: ReadonlySignal<Trial | null>;
  /** The positions that differ in the timer from what it held before. */
  readonly tried: ReadonlySignal<readonly Change[]>;
  /** Whether positions are being tried now. */
  readonly #trying = signal(false, { name: 'trying' });
  readonly #trials = signal<ReadonlyMap<string, Trial>>(kept() ?? new Map(), { name: 'trials' });
  readonly #held: ReadonlySignal<TimerProgram | null>;
  readonly #keyOf: (program: TimerProgram) => string;

  /**
   * @param held what the connected timer holds.
   * @param keyOf gives the key of a program of the timer from which the one on the screen came: see `programKey`.
   */
  constructor(held: ReadonlySignal<TimerProgram | null>, keyOf: (program: TimerProgram) => string) {
    this.#held = held;
    this.#keyOf = keyOf;
    this.current = computed(() => {
      const trial = held.value && this.#trials.value.get(keyOf(held.value));
      // The stored text may be damaged.
      return trial && held.value && sameLayout(trial.before.identity, held.value.identity) ? trial : null;
    });
    this.open = computed(() => {
      const current = this.current.value;
      const isOpen = (trial: Trial): boolean =>
        trial === current ? this.tried.value.length > 0 && !this.#trying.value : trial.touched.size > 0;
      return [...this.#trials.value].filter(([, trial]) => isOpen(trial)).map(([key, trial]) => ({ key, ...trial }));
    });
    this.tried = computed(() => {
      const trial = this.current.value;
      if (!trial || !held.value) return [];
      return differences(trial.before, held.value).filter(({ field }) => trial.touched.has(fieldKey(field)));
    });
  }

  /** Positions are being tried from now on, or no longer. */
  setTrying(on: boolean): void {
    this.#trying.value = on;
  }

  /** The positions that were tried stay in that timer: nobody will ask again. */
  forget(key: string): void {
    this.#save((trials) => void trials.delete(key));
  }

  /** Those of simulated timers that went with their page. */
  forgetSimulated(): void {
    this.#save((trials) => {
      for (const key of [...trials.keys()]) if (isSimulated({ key })) trials.delete(key);
    });
  }

  /** The values that bring back what the timer held before. */
  takeBack(): readonly FieldValue[] {
    return this.tried.value.flatMap(({ field, from }) => (from === null ? [] : [{ field, value: from }]));
  }

  /** Keeps the trial for the present content of the timer; null ends it. */
  set(trial: Trial | null): void {
    const held = this.#held.peek();
    if (!held) return;
    const key = this.#keyOf(held);
    this.#save((trials) => void (trial ? trials.set(key, trial) : trials.delete(key)));
  }

  #save(change: (trials: Map<string, Trial>) => void): void {
    // Other tabs keep theirs in the same place.
    const trials = new Map(kept() ?? this.#trials.peek());
    change(trials);
    this.#trials.value = trials;
    saveSetting(
      TRIALS,
      [...trials].map(([key, { before, touched }]) => ({ key, before, touched: [...touched] })),
    );
  }
}

/** Null where the browser keeps nothing. */
function kept(): ReadonlyMap<string, Trial> | null {
  const trials = loadSetting(TRIALS, trialsSchema);
  // Earlier versions had the number of a tab in the key, and lost the question with the tab.
  const keyOf = (key: string, before: TimerProgram): string => programKey(before, isSimulated({ key }));
  return (
    trials &&
    new Map(trials.map(({ key, before, touched }) => [keyOf(key, before), { before, touched: new Set(touched) }]))
  );
}
