import { type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { loadSetting, saveSetting } from '../browser/settings.js';

/** What is told to who comes here for the first time. */
export const STEPS = ['read', 'write', 'fly'] as const;
export type FirstStep = (typeof STEPS)[number];

/** The first steps: shown once, one after the other, until they were seen or skipped. */
export class FirstSteps {
  readonly #shown = signal<FirstStep | null>(loadSetting('first-steps', v.boolean()) === true ? null : STEPS[0]);
  /** The one that is shown; null when they were seen. */
  readonly shown: ReadonlySignal<FirstStep | null> = this.#shown;

  /** To another one; past the last they were seen. */
  show(step: FirstStep | undefined): void {
    if (step === undefined) this.end();
    else this.#shown.value = step;
  }

  /** They were seen, skipped, or are not needed any more. */
  end(): void {
    if (this.#shown.peek() === null) return;
    this.#shown.value = null;
    saveSetting('first-steps', true);
  }
}
