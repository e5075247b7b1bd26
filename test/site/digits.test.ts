import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { contestDay, fillLibrary } from './library.js';
import { PHONE } from './page.js';

const WIDTHS = [160, 195, 240, 260, 320, 360, 400];
/** Sizes of letters that a reader may have set in the browser, in pixels. */
const FONTS = [16, 24, 32];

/**
 * Everything with digits of which a part is cut off: in a field that is too narrow, behind an edge that hides it, or
 * outside of the window with nothing to scroll.
 */
function cutDigits(): string[] {
  const found: string[] = [];
  const seen = (element: Element) => element.checkVisibility({ visibilityProperty: true });
  /** The first edge that hides what is beyond it and cannot be scrolled, from the inside out. */
  const isWithin = (element: Element, { left, right }: DOMRect): boolean => {
    for (let each: Element | null = element; each; each = each.parentElement) {
      const { overflowX, clipPath, position } = getComputedStyle(each);
      if (clipPath !== 'none') return true;
      const edge = each.getBoundingClientRect();
      if (overflowX === 'auto' || overflowX === 'scroll') return true;
      if (overflowX === 'hidden' || overflowX === 'clip') return left >= edge.left - 1 && right <= edge.right + 1;
      if (position === 'fixed') break;
    }
    return left >= -1 && right <= innerWidth + 1;
  };
  for (const input of document.querySelectorAll<HTMLInputElement>('#app input:is([type=text], :not([type]))')) {
    if (!seen(input) || !/\d/.test(input.value)) continue;
    const isCut = input.scrollWidth > input.clientWidth || !isWithin(input, input.getBoundingClientRect());
    if (isCut) found.push(`${input.ariaLabel} ${input.value}: ${input.scrollWidth} in ${input.clientWidth}`);
  }
  const texts = document.createTreeWalker(document.querySelector('#app') as Element, NodeFilter.SHOW_TEXT);
  for (let text = texts.nextNode(); text; text = texts.nextNode()) {
    const { parentElement: around, textContent } = text;
    if (!around || !/\d/.test(textContent ?? '') || !seen(around) || around.closest('svg, option')) continue;
    const range = document.createRange();
    range.selectNodeContents(text);
    const outside = [...range.getClientRects()].filter((place) => place.width > 1 && !isWithin(around, place));
    if (outside.length > 0) found.push(`${textContent?.slice(0, 40)}, in ${around.tagName} ${around.className}`);
  }
  return found;
}

/** Looks at the present screen in each width, with each size of letters. */
async function expectWhole(app: AppPage, screen: string): Promise<void> {
  const cut: string[] = [];
  for (const font of FONTS) {
    // What rem is made of. Windows measured in em stay as they are.
    await app.page.evaluate((size) => document.documentElement.style.setProperty('font-size', `${size}px`), font);
    for (const width of WIDTHS) {
      await app.resize({ width, height: 844 });
      for (const each of await app.page.evaluate(cutDigits)) cut.push(`${screen}, ${width} px, ${font} px: ${each}`);
    }
  }
  expect.soft(cut).toEqual([]);
}

test.each([3, 8])('no digit of a program with %i servos is cut off on any phone', async (servos) => {
  const app = await AppPage.connected({ ...PHONE, bench: { identity: { servos } } });
  await app.type('Function 9 time', '9:48.50');
  await app.type('DT time', '10:48.50');
  await app.type('Function 1, S1', '115');
  await app.page.locator('.edit-sheet').waitFor({ state: 'detached' });
  await expectWhole(app, 'the table and the strip');
  await app.field('DT time').tap();
  await app.page.locator('.edit-sheet').waitFor();
  await expectWhole(app, 'the keys');
  await app.page.locator('.edit-sheet .primary').click();
  await app.showFigures();
  await expectWhole(app, 'what the strip opens');
  await app.page.locator('.strip-close').click();
  await app.goTo('Bench');
  await app.page.getByRole('checkbox', { name: /^The propeller/ }).check();
  await app.button('Function 1').tap();
  await app.page.locator('.bench-trim').waitFor();
  await expectWhole(app, 'the bench');
  await app.goTo('Memories');
  await app.page.locator('.memory-card').first().waitFor();
  await expectWhole(app, 'the memories');
});

test('no digit of a score card is cut off on any phone', async () => {
  const app = await AppPage.open(PHONE);
  const long = { round: '12', result: 1234.56, maximum: 234.56, modelName: 'W'.repeat(60) };
  const flights = contestDay().map((record, at) =>
    at === 0 ? { ...record, flight: { ...record.flight, ...long } } : record,
  );
  await fillLibrary(app, { models: [], settings: [], flights });
  await app.page.evaluate(() => location.assign('#library/flights'));
  await app.reload();
  await app.button(en.flights.score.open).click();
  await app.field(en.flights.score.maximum).waitFor();
  await expectWhole(app, 'the score card');
});
