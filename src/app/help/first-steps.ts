import { type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import { loadSetting, saveSetting } from '../browser/settings.js';

/** What a new pilot is told. */
export const STEPS = ['read', 'write', 'fly'] as const;
export type FirstStep = (typeof STEPS)[number];

/** The first steps: shown once, one after the other, until the pilot has seen or skipped them. */
export class FirstSteps {
  readonly #shown = signal<FirstStep | null>(loadSetting('first-steps', v.boolean()) === true ? null : STEPS[0]);
  /** The step that is shown; null once all were seen. */
  readonly shown: ReadonlySignal<FirstStep | null> = this.#shown;

  /** Shows another step. After the last one they count as seen. */
  show(step: FirstStep | undefined): void {
    if (step === undefined) this.end();
    else this.#shown.value = step;
  }

  /** They were seen or skipped, or are not needed any more. */
  end(): void {
    if (this.#shown.peek() === null) return;
    this.#shown.value = null;
    saveSetting('first-steps', true);
  }
}
