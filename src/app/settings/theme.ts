import { effect, type ReadonlySignal, signal } from '@preact/signals';
import * as v from 'valibot';
import type { Query } from '../browser/doors.js';
import { querySignal } from '../browser/query-signal.js';
import { loadSetting, saveSetting } from '../browser/settings.js';

/** The themes: as the system says, light, dark, or with the strongest contrast for bright sun. */
export const THEMES = ['system', 'light', 'dark', 'sun'] as const;
export type ThemeName = (typeof THEMES)[number];

/** The colour of the browser's bars around the page: that of the strip beside them. */
const BARS: Readonly<Record<Exclude<ThemeName, 'system'>, string>> = {
  light: '#ffffff',
  dark: '#161c22',
  sun: '#ffffff',
};

/** The theme that the pilot has chosen. */
export class Theme {
  readonly #chosen = signal<ThemeName>(loadSetting('theme', v.picklist(THEMES)) ?? 'system');
  readonly chosen: ReadonlySignal<ThemeName> = this.#chosen;

  choose(name: ThemeName): void {
    this.#chosen.value = name;
    saveSetting('theme', name);
  }

  /**
   * Applies the theme to a page, from now on.
   * @param dark whether the system is dark; null when the browser does not say.
   * @returns a function that ends this.
   */
  follow({ documentElement, head }: Document, dark: Query | null): () => void {
    const isDark = querySignal(dark);
    const stop = effect(() => {
      const { value } = this.chosen;
      const shown = value === 'system' ? (isDark.matches.value ? 'dark' : 'light') : value;
      documentElement.setAttribute('data-theme', shown);
      for (const bar of head.querySelectorAll<HTMLMetaElement>('meta[name="theme-color"]')) bar.content = BARS[shown];
    });
    return () => {
      isDark.stop();
      stop();
    };
  }
}
