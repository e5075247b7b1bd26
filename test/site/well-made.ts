import { source } from 'axe-core';
import { expect } from 'vitest';
import type { AppPage } from './app-page.js';

/** What axe finds wrong, one line for each. */
async function violations(app: AppPage): Promise<string[]> {
  // Without what moves: halfway between two colours the contrast is of neither.
  await app.page.emulateMedia({ reducedMotion: 'reduce' });
  await app.page.evaluate(source);
  const found = await app.page.evaluate(async () => {
    const { axe } = window as unknown as { axe: typeof import('axe-core') };
    return (await axe.run()).violations;
  });
  return found.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).join(', ')}`);
}

/** Buttons, fields and choices that a finger would miss, with their sizes. */
function smallTargets(app: AppPage): Promise<string[]> {
  return app.page.evaluate(() => {
    const targets = [...document.querySelectorAll('button, input, select, summary')].map((element) =>
      element.matches('[type=checkbox], [type=radio]') ? (element.closest('label') ?? element) : element,
    );
    return targets.flatMap((element) => {
      const { width, height } = element.getBoundingClientRect();
      const isSeen = width > 0 && height > 0;
      return isSeen && (width < 44 || height < 44) ? [`${element.outerHTML.slice(0, 90)} ${width} x ${height}`] : [];
    });
  });
}

/** What axe finds wrong, what a finger would miss, and what stands over the edge: nothing. */
export async function isWellMade(app: AppPage, screen: string): Promise<void> {
  expect(await violations(app), screen).toEqual([]);
  expect(await smallTargets(app), screen).toEqual([]);
  await app.expectNoSidewaysScrolling();
}
