import { effect, signal } from '@preact/signals';
import * as v from 'valibot';
import { loadSetting, saveSetting } from '../storage/settings.js';

/** How the page looks: as the system says, light, dark, or as strong as can be for bright sun. */
export const THEMES = ['system', 'light', 'dark', 'sun'] as const;
export type ThemeName = (typeof THEMES)[number];

/** The colour of the bars that a browser draws around the page; the system's stand in the page. */
const BARS: Readonly<Record<Exclude<ThemeName, 'system'>, string>> = {
  light: '#f4f7f9',
  dark: '#10171e',
  sun: '#ffffff',
};

/** The look that the pilot has chosen. */
export class Theme {
  readonly chosen = signal<ThemeName>(loadSetting('theme', v.picklist(THEMES)) ?? 'system');

  choose(name: ThemeName): void {
    this.chosen.value = name;
    saveSetting('theme', name);
  }

  /** Keeps a page as chosen. @returns a function that ends it. */
  follow({ documentElement, head }: Document): () => void {
    const bars = [...head.querySelectorAll<HTMLMetaElement>('meta[name="theme-color"]')];
    const usual = bars.map(({ content }) => content);
    return effect(() => {
      const { value } = this.chosen;
      if (value === 'system') documentElement.removeAttribute('data-theme');
      else documentElement.setAttribute('data-theme', value);
      bars.forEach((bar, index) => {
        bar.content = value === 'system' ? (usual[index] as string) : BARS[value];
      });
    });
  }
}
