import { expect } from 'vitest';
import { violations } from '../tools/axe.js';
import type { AppPage } from './app-page.js';

type Sizes = Readonly<Record<string, { readonly width: number; readonly height: number }>>;
/** A phone and a desktop. */
export const SIZES = {
  phone: { width: 390, height: 844 },
  desktop: { width: 1280, height: 800 },
} as const satisfies Sizes;
export const THEMES = ['light', 'dark', 'sun'] as const;

/** Buttons, fields and choices that a finger would miss, or a mouse where there is room and one, with their sizes. */
function smallTargets(app: AppPage): Promise<string[]> {
  return app.page.evaluate(() => {
    const targets = [...document.querySelectorAll('button, input, select, summary')].map((element) =>
      element.matches('[type=checkbox], [type=radio]') ? (element.closest('label') ?? element) : element,
    );
    // The least that WCAG asks for a mouse: heads of the table and low lanes are lower than its rows.
    const least = matchMedia('(min-width: 760px) and (hover: hover) and (pointer: fine)').matches ? 24 : 44;
    return targets.flatMap((element) => {
      // A lane is as wide as the picture, and can be hit anywhere: its name is one more way to it.
      if (element.closest('.lane-buttons')) return [];
      const { width, height } = element.getBoundingClientRect();
      const isSeen = width > 0 && height > 0;
      return isSeen && (width < least || height < least)
        ? [`${element.outerHTML.slice(0, 90)} ${width} x ${height}`]
        : [];
    });
  });
}

/** The page in a theme, without the pilot's hands: its model is not asked. */
export async function showTheme(app: AppPage, theme: string): Promise<void> {
  await app.page.evaluate((name) => document.documentElement.setAttribute('data-theme', name), theme);
}

/**
 * What axe finds wrong, what a finger would miss, and what stands over the edge, in each size and theme: nothing. A
 * theme changes colours and nothing else, so the rules that are not about colours are looked at once for each size.
 */
export async function isWellMade(app: AppPage, screen: string, sizes: Sizes = SIZES): Promise<void> {
  const { page } = app;
  const [size, theme] = [page.viewportSize(), await page.locator('html').getAttribute('data-theme')];
  // Without what moves: halfway between two colours the contrast is of neither.
  await page.emulateMedia({ reducedMotion: 'reduce' });
  for (const [name, viewport] of Object.entries(sizes)) {
    await app.resize(viewport);
    for (const [index, each] of THEMES.entries()) {
      await showTheme(app, each);
      expect(await violations(page, index > 0), `axe finds: ${screen}, ${name}, ${each}`).toEqual([]);
    }
    expect(await smallTargets(app), `targets that are too small: ${screen}, ${name}`).toEqual([]);
    await app.expectNoSidewaysScrolling();
  }
  if (size) await app.resize(size);
  if (theme) await showTheme(app, theme);
}
