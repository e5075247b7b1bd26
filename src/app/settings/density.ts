import { effect, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import type { Query } from '../browser/doors.js';
import { loadSetting, saveSetting } from '../browser/settings.js';

/** How high rows are: as the screen asks for, as many as fit, or with room for a cold finger. */
export const DENSITIES = ['system', 'dense', 'comfortable'] as const;
export type DensityName = (typeof DENSITIES)[number];

/** A tablet: it is touched, and has room. */
export const TABLET = '(pointer: coarse) and (min-width: 760px) and (min-height: 600px)';

/** The height of rows that the pilot has chosen. */
export class Density {
  readonly #chosen = signal<DensityName>(loadSetting('density', v.picklist(DENSITIES)) ?? 'system');
  readonly chosen: ReadonlySignal<DensityName> = this.#chosen;

  choose(name: DensityName): void {
    this.#chosen.value = name;
    saveSetting('density', name);
  }

  /**
   * Keeps a page as chosen.
   * @param tablet whether the screen is one, as the browser says it; null where it does not.
   * @returns a function that ends it.
   */
  follow({ documentElement }: Document, tablet: Query | null): () => void {
    const isTablet = signal(tablet?.matches ?? false);
    const note = (): void => {
      isTablet.value = tablet?.matches ?? false;
    };
    tablet?.addEventListener?.('change', note);
    const stop = effect(() => {
      const { value } = this.chosen;
      const shown = value === 'system' ? (isTablet.value ? 'comfortable' : 'dense') : value;
      documentElement.setAttribute('data-density', shown);
    });
    return () => {
      tablet?.removeEventListener?.('change', note);
      stop();
    };
  }
}
