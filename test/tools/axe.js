// What axe finds wrong on a page.

import axeCore from 'axe-core';

/** The rules that are about colours: a theme changes nothing else. */
const OF_COLOURS = ['color-contrast', 'link-in-text-block'];

/**
 * One line for each rule that is broken.
 * @param {import('playwright').Page} page
 * @param {boolean} onlyColours whether to look at the colours alone
 * @returns {Promise<string[]>}
 */
export async function violations(page, onlyColours) {
  if (await page.evaluate(() => !('axe' in window))) await page.evaluate(axeCore.source);
  const found = await page.evaluate(
    async (runOnly) => {
      const { axe } = /** @type {{ axe: typeof import('axe-core') }} */ (/** @type {unknown} */ (window));
      // What lies behind a dialog cannot be reached, and is looked at without it.
      const stage = [...document.querySelectorAll('dialog:modal')].at(-1) ?? document;
      // Of what is right there is nothing to tell: most of the time would go into that.
      return (await axe.run(stage, { resultTypes: ['violations'], ...(runOnly && { runOnly }) })).violations;
    },
    onlyColours ? OF_COLOURS : null,
  );
  return found.map(({ id, nodes }) => `${id}: ${nodes.map(({ target }) => target.join(' ')).join(', ')}`);
}
