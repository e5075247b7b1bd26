import type { AppPage } from './app-page.js';

/** A phone and a desktop. */
export const SIZES = {
  phone: { width: 390, height: 844 },
  desktop: { width: 1280, height: 800 },
} as const;
export const THEMES = ['light', 'dark', 'sun'] as const;

/** The page in a theme, without the pilot's hands: its model is not asked. */
export async function showTheme(app: AppPage, theme: string): Promise<void> {
  await app.page.evaluate((name) => document.documentElement.setAttribute('data-theme', name), theme);
}
