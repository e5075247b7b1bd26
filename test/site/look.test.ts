import { source } from 'axe-core';
import { describe, expect, test } from 'vitest';
import { AppPage } from './app-page.js';

const sizes = { phone: { width: 390, height: 844 }, desktop: { width: 1280, height: 800 } } as const;

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
    const targets = [...document.querySelectorAll('button, input, summary')].map((element) =>
      element.matches('[type=checkbox], [type=radio]') ? (element.closest('label') ?? element) : element,
    );
    return targets.flatMap((element) => {
      const { width, height } = element.getBoundingClientRect();
      const isSeen = width > 0 && height > 0;
      return isSeen && (width < 44 || height < 44) ? [`${element.outerHTML.slice(0, 90)} ${width} x ${height}`] : [];
    });
  });
}

/** Values and old values that are cut off, covered, or stand out of their field. Runs in the page. */
function hidden(): string[] {
  const pen = document.createElement('canvas').getContext('2d') as CanvasRenderingContext2D;
  /** Where the letters of a field are. */
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
    const was = input.parentElement?.querySelector('.was')?.getBoundingClientRect();
    const label = input.closest('td')?.querySelector('.cell-name')?.getBoundingClientRect();
    const field = input.getBoundingClientRect();
    if (was && (was.left < field.left || was.right > field.right)) found.push(`${name}: the old value stands out`);
    if (was && meet(was, lettersOf(input))) found.push(`${name}: the old value covers the new one`);
    if (was && label && meet(was, label)) found.push(`${name}: the old value covers the label`);
    return found;
  });
}

async function isWellMade(app: AppPage, screen: string): Promise<void> {
  expect(await violations(app), screen).toEqual([]);
  expect(await smallTargets(app), screen).toEqual([]);
  await app.expectNoSidewaysScrolling();
}

for (const [size, viewport] of Object.entries(sizes)) {
  for (const colorScheme of ['light', 'dark'] as const) {
    test(`every screen can be used by everyone: ${size}, ${colorScheme}`, async () => {
      const app = await AppPage.open({ viewport, colorScheme, bench: {} });
      await isWellMade(app, 'start');
      await app.bench((bench) => bench.dismissChooser());
      await app.button('Connect').click();
      await app.says('No port was chosen.');
      await isWellMade(app, 'start with a notice');
      await app.bench((bench) => bench.chooseAdapter());
      await app.connect();
      await isWellMade(app, 'program');

      await app.type('Function 2, S1', '131');
      await app.type('Function 3, S2', '99');
      await app.type('Idle throttle', 'x');
      await app.type('DT time', '5');
      await isWellMade(app, 'program with errors, edits and warnings');

      await app.type('Function 2, S1', '100');
      await app.type('Idle throttle', '30');
      await app.review();
      await isWellMade(app, 'difference');
      await app.dialog.getByRole('checkbox', { name: 'I have read this' }).check();
      await app.tickSafety();
      await app.dialog.getByRole('button', { name: /^Write/ }).click();
      await app.result('Verified.');
      await isWellMade(app, 'result');
      await app.close();
      await app.text('Line').click();
      await isWellMade(app, 'line');
      await app.bench((bench) => bench.adapter.unplug());
      await app.says('The connection is gone.');
      await isWellMade(app, 'after a loss');
    });
  }
}

describe('nothing is cut off or covered', () => {
  for (const width of [320, 390, 768, 1280]) {
    test(`at ${width} px`, async () => {
      const app = await AppPage.open({ viewport: { width, height: 800 }, bench: {} });
      await app.expectNoSidewaysScrolling();
      await app.connect();
      await app.expectNoSidewaysScrolling();
      await app.type('Motor stop', '39.95');
      await app.type('Function 1 time', '1:30.25');
      await app.type('DT', '10:00');
      for (const servo of ['S1', 'S2', 'S3']) await app.type(`Function 2, ${servo}`, '130');
      await app.text('Line').click();
      await app.expectNoSidewaysScrolling();
      expect(await app.page.evaluate(hidden)).toEqual([]);
    });
  }
});
