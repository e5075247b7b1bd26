import { effect, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import type { Query } from '../browser/doors.js';
import { querySignal } from '../browser/query-signal.js';
import { loadSetting, saveSetting } from '../browser/settings.js';

/** The heights of rows: as the screen suggests, as many rows as fit, or large enough for a cold finger. */
export const DENSITIES = ['system', 'dense', 'comfortable'] as const;
export type DensityName = (typeof DENSITIES)[number];

/** A tablet: a touch screen with room. */
export const TABLET = '(pointer: coarse) and (min-width: 760px) and (min-height: 600px)';

/** The row height that the pilot has chosen. */
export class Density {
  readonly #chosen = signal<DensityName>(loadSetting('density', v.picklist(DENSITIES)) ?? 'system');
  readonly chosen: ReadonlySignal<DensityName> = this.#chosen;

  choose(name: DensityName): void {
    this.#chosen.value = name;
    saveSetting('density', name);
  }

  /**
   * Applies the choice to a page, from now on.
   * @param tablet whether the screen is a tablet; null when the browser does not say.
   * @returns a function that ends this.
   */
  follow({ documentElement }: Document, tablet: Query | null): () => void {
    const isTablet = querySignal(tablet);
    const stop = effect(() => {
      const { value } = this.chosen;
      const shown = value === 'system' ? (isTablet.matches.value ? 'comfortable' : 'dense') : value;
      documentElement.setAttribute('data-density', shown);
    });
    return () => {
      isTablet.stop();
      stop();
    };
  }
}
