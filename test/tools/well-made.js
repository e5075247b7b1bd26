// What is wrong with a page for some of those who use it: what axe finds, what a finger would miss, what is too wide.

import axeCore from 'axe-core';

/** The rules that are about colours: a theme changes nothing else. */
const OF_COLOURS = ['color-contrast', 'link-in-text-block'];

/**
 * A line for each fault.
 * @param {import('playwright').Page} page
 * @param {boolean} onlyColours whether to look at the colours alone
 * @returns {Promise<string[]>}
 */
export async function faultsOf(page, onlyColours) {
  const found = await violations(page, onlyColours);
  return onlyColours ? found : [...found, ...(await page.evaluate(smallTargets)), ...(await page.evaluate(tooWide))];
}

/** @param {import('playwright').Page} page @param {boolean} onlyColours */
async function violations(page, onlyColours) {
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

/** Buttons, fields and choices that a finger would miss, or a mouse where there is room and one. Runs in the page. */
function smallTargets() {
  const targets = [...document.querySelectorAll('button, input, select, summary')].map((element) =>
    element.matches('[type=checkbox], [type=radio]') ? (element.closest('label') ?? element) : element,
  );
  // The least that WCAG asks for a mouse: heads of the table and low lanes are lower than its rows.
  const least = matchMedia('(hover: hover) and (pointer: fine) and (min-width: 47.5em) and (min-height: 30em)').matches
    ? 24
    : 44;
  return targets.flatMap((element) => {
    const { width, height } = element.getBoundingClientRect();
    const isSeen = width > 0 && height > 0;
    return isSeen && (width < least || height < least)
      ? [`too small: ${element.outerHTML.slice(0, 90)} ${width} x ${height}`]
      : [];
  });
}

/** What stands over the edge of the window. Runs in the page. */
export function tooWide() {
  const { scrollWidth, clientWidth } = document.documentElement;
  if (scrollWidth <= clientWidth) return [];
  const over = [...document.body.querySelectorAll('*')].filter(
    (element) => element.getBoundingClientRect().right > clientWidth,
  );
  return [
    `${scrollWidth - clientWidth} px wider than the window: ${over.map((each) => each.outerHTML.slice(0, 90)).join(', ')}`,
  ];
}
