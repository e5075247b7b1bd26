import { effect, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import type { Query } from '../browser/doors.js';
import { loadSetting, saveSetting } from '../browser/settings.js';

/** How the page looks: as the system says, light, dark, or as strong as can be for bright sun. */
export const THEMES = ['system', 'light', 'dark', 'sun'] as const;
export type ThemeName = (typeof THEMES)[number];

/** The colour of the bars that a browser draws around the page: that of the strip which they join. */
const BARS: Readonly<Record<Exclude<ThemeName, 'system'>, string>> = {
  light: '#ffffff',
  dark: '#161c22',
  sun: '#ffffff',
};

/** The look that the pilot has chosen. */
export class Theme {
  readonly #chosen = signal<ThemeName>(loadSetting('theme', v.picklist(THEMES)) ?? 'system');
  readonly chosen: ReadonlySignal<ThemeName> = this.#chosen;

  choose(name: ThemeName): void {
    this.#chosen.value = name;
    saveSetting('theme', name);
  }

  /**
   * Keeps a page as chosen.
   * @param dark whether the system is dark, as the browser says it; null where it does not.
   * @returns a function that ends it.
   */
  follow({ documentElement, head }: Document, dark: Query | null): () => void {
    const isDark = signal(dark?.matches ?? false);
    const note = (): void => {
      isDark.value = dark?.matches ?? false;
    };
    // Safari had none of it for long.
    dark?.addEventListener?.('change', note);
    const stop = effect(() => {
      const { value } = this.chosen;
      const shown = value === 'system' ? (isDark.value ? 'dark' : 'light') : value;
      documentElement.setAttribute('data-theme', shown);
      for (const bar of head.querySelectorAll<HTMLMetaElement>('meta[name="theme-color"]')) bar.content = BARS[shown];
    });
    return () => {
      dark?.removeEventListener?.('change', note);
      stop();
    };
  }
}
