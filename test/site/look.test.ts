import { describe, expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { showTheme, THEMES } from './themes.js';

/** Finds values and old values that are cut off, covered, or outside their field. Runs in the page. */
function hidden(): string[] {
  const pen = document.createElement('canvas').getContext('2d') as CanvasRenderingContext2D;
  /** The place of the letters in a field. */
  const lettersOf = (input: HTMLInputElement): DOMRect => {
    const style = getComputedStyle(input);
    pen.font = `${style.fontWeight} ${style.fontSize} ${style.fontFamily}`;
    const { left, right, top, bottom } = input.getBoundingClientRect();
    const [before, after, above, below] = (['Left', 'Right', 'Top', 'Bottom'] as const).map((side) =>
      Number.parseFloat(style[`padding${side}`]),
    ) as [number, number, number, number];
    const width = pen.measureText(input.value).width;
    const height = 0.7 * Number.parseFloat(style.fontSize);
    const middle = (top + above + bottom - below) / 2;
    const x = style.textAlign === 'end' ? right - after - width : left + before;
    return new DOMRect(x, middle - height / 2, width, height);
  };
  const meet = (a: DOMRect, b: DOMRect): boolean =>
    a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
  return [...document.querySelectorAll<HTMLInputElement>('.value input')].flatMap((input) => {
    const name = input.ariaLabel;
    const found = input.scrollWidth > input.clientWidth ? [`${name} is cut off: ${input.value}`] : [];
    const was = [input.parentElement?.querySelector('.was, .old-value > *')?.getBoundingClientRect()].find(
      // On a phone there is no room for it.
      (box) => box && box.width > 0,
    );
    const label = input.closest('td')?.querySelector('.cell-name')?.getBoundingClientRect();
    const unit = input.parentElement?.querySelector('.unit')?.getBoundingClientRect();
    const field = input.getBoundingClientRect();
    if (unit && meet(unit, lettersOf(input))) found.push(`${name}: its unit covers it`);
    if (was && (was.left < field.left || was.right > field.right)) found.push(`${name}: the old value stands out`);
    if (was && meet(was, lettersOf(input))) found.push(`${name}: the old value covers the new one`);
    if (was && label && meet(was, label)) found.push(`${name}: the old value covers the label`);
    return found;
  });
}

test('a disabled control looks disabled, in each theme', async () => {
  const app = await AppPage.connected();
  await app.bench((bench) => bench.adapter.unplug());
  await app.says(en.link.lost.title);
  for (const theme of THEMES) {
    await showTheme(app, theme);
    const looks = await app.page.evaluate(() => {
      const of = (button: Element | undefined) => {
        if (!button) throw new Error('There is no such button.');
        const { color, borderTopStyle, backgroundColor } = getComputedStyle(button);
        return { color, borderTopStyle, backgroundColor };
      };
      const buttons = [...document.querySelectorAll('.actions button')];
      const off = buttons.find(({ textContent }) => textContent?.startsWith('Write'));
      const aria = off?.cloneNode(true) as HTMLButtonElement;
      aria.disabled = false;
      aria.ariaDisabled = 'true';
      off?.after(aria);
      const on = aria.cloneNode(true) as HTMLButtonElement;
      on.ariaDisabled = null;
      off?.after(on);
      const found = { off: of(off), aria: of(aria), on: of(on), ink: getComputedStyle(document.body).color };
      aria.remove();
      on.remove();
      return found;
    });
    expect(looks.off, theme).toEqual(looks.aria);
    expect(looks.off, theme).toMatchObject({ borderTopStyle: 'dashed', backgroundColor: 'rgba(0, 0, 0, 0)' });
    expect(looks.on, theme).toMatchObject({ borderTopStyle: 'solid', color: looks.ink });
    const apart = Math.abs(lightness(looks.off.color) - lightness(looks.ink));
    expect(apart, `${theme}: a disabled control has nearly the colour of an enabled one`).toBeGreaterThan(80);
  }
});

/** The numbers of `rgb(r, g, b)`, 0 to 255. */
function lightness(colour = ''): number {
  const parts = (colour.match(/\d+/g) ?? []).slice(0, 3).map(Number);
  return parts.reduce((sum, part) => sum + part, 0) / 3;
}

describe('nothing is cut off or covered', () => {
  const widths = [320, 390, 768, 1100, 1280];

  test(`at ${widths.join(', ')} px, in light and for the sun`, async () => {
    const app = await AppPage.connected();
    await app.type('Motor stop time', '39.95');
    await app.type('Function 1 time', '1:30.25');
    await app.type('DT time', '10:00');
    for (const servo of ['S1', 'S2', 'S3']) await app.type(`Function 2, ${servo}`, '130');
    for (const width of widths) {
      await app.resize({ width, height: 800 });
      for (const theme of ['light', 'sun']) {
        await showTheme(app, theme);
        await app.expectNoSidewaysScrolling();
        expect(await app.page.evaluate(hidden), `${width} px, ${theme}`).toEqual([]);
      }
    }
  });

  test('in a table of many servos, an old value and the new one', async () => {
    const app = await AppPage.connected({
      viewport: { width: 1366, height: 800 },
      bench: { identity: { functions: 20, servos: 8 } },
    });
    await app.type('Function 19 time', '1:30.25');
    await app.type('DT time', '10:00');
    await app.type('Function 9, S1', '120');
    await app.page.locator('.old-value').nth(2).waitFor();
    expect(await app.page.evaluate(hidden)).toEqual([]);
  });
});
