import { describe, expect, test } from 'vitest';
import { AppPage } from './app-page.js';
import { isWellMade, SIZES, showTheme, THEMES } from './well-made.js';

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

test('every screen can be used by everyone', async () => {
  const app = await AppPage.open({ bench: {} });
  await app.button('Connect').first().waitFor();
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
  await app.button('5 s').first().click();
  await app.review();
  await isWellMade(app, 'difference');
  await app.dialog.getByRole('checkbox', { name: 'I have read this' }).check();
  await app.tickSafety();
  await app.dialog.getByRole('button', { name: /^Write/ }).click();
  await app.result('Verified.');
  await isWellMade(app, 'result');
  await app.close();
  await app.goTo('Line');
  await isWellMade(app, 'line');
  await app.bench((bench) => bench.adapter.unplug());
  await app.says('The adapter is unplugged.');
  await isWellMade(app, 'after a loss');
});

test('what the page says while connecting can be used by everyone', async () => {
  const app = await AppPage.open({ bench: { granted: true } });
  await app.goTo('Settings');
  await app.text('Serial settings').click();
  await isWellMade(app, 'known adapters and settings');
  await app.goTo('Program');
  await app.bench((bench) => bench.sleep());
  await app.button('Connect').click();
  await app.text(/^No answer for /).waitFor();
  await isWellMade(app, 'waiting');
  await app.bench((bench) => bench.press());
  await app.hasRead();
  await app.goTo('Settings');
  await app.text('About this timer').click();
  await isWellMade(app, 'settings');
  await app.goTo('Memories');
  await isWellMade(app, 'backups');
  await app.button('Copy to…: M1').click();
  await app.button('Copy M1 to M3…').click();
  await isWellMade(app, 'memories');
  await app.button('Cancel').click();
  await app.goTo('Program');

  await app.type('DT time', '4:00');
  await app.type('Function 2, S1', '7');
  await app.bench((bench) => {
    bench.content.times[10] = 21000;
  });
  await app.review();
  await isWellMade(app, 'conflict');
  await app.bench((bench) => bench.unplugAt('SETTIMERS'));
  await app.tickSafety();
  await app.dialog.getByRole('button', { name: 'Write 2 changes' }).click();
  await app.result('It is not certain what the timer holds.');
  await app.close();
  await app.bench((bench) => bench.replug());
  await app.isReady();
  await app.page.locator('summary', { hasText: 'Compare' }).click();
  await isWellMade(app, 'an interrupted write');
  await app.fly('M2');
  await app.button('Make M1 fly next and look').waitFor();
  await isWellMade(app, 'an interrupted write into another memory');
});

test('every tool can be used by everyone', async () => {
  const app = await AppPage.open({ bench: { granted: true } });
  const open = (tool: string): Promise<void> => app.page.locator('summary', { hasText: tool }).first().click();
  await app.button('Connect').first().click();
  await app.hasRead();
  await open('As a table');
  await isWellMade(app, 'the picture and the preview');
  await app.button('Name the servos…').click();
  // A narrower window has no room for the picture and its tools.
  await isWellMade(app, 'the names of the servos', { desktop: SIZES.desktop });
  await app.button('Cancel').click();
  await app.button('Change presets').click();
  await app.button('Tools for Function 4').click();
  await isWellMade(app, 'the tools of the table');
  await app.goTo('Settings');
  await app.page.getByRole('checkbox', { name: /^Expert/ }).check();
  await app.goTo('Bench');
  await app.page.getByRole('checkbox', { name: /^The propeller/ }).check();
  await app.button('Function 2').click();
  await app.text('Servos at function 2').first().waitFor();
  await app.page.getByRole('switch').click();
  await app.goTo('Program');
  await app.button('Stop following').first().waitFor();
  await app.type('Function 2, S1', '7');
  await app.text('1 tried in the timer').first().waitFor();
  await isWellMade(app, 'following');
  await app.button('Stop following').first().click();
  await app.button('Keep it').first().waitFor();
  await isWellMade(app, 'tried');
  await app.button('Keep it').first().click();
  await app.goTo('Memories');
  await app.button('Read and keep all…').click();
  const dialog = app.page.getByRole('dialog');
  await dialog.getByRole('button', { name: 'Read and keep' }).click();
  await dialog.getByText('were read and kept').waitFor();
  await dialog.getByRole('button', { name: 'Close' }).click();
  await dialog.waitFor({ state: 'hidden' });
  await isWellMade(app, 'memories');
  await app.button('Compare with M1: M2').click();
  await isWellMade(app, 'memories side by side');
});

test('every dialog can be used by everyone', async () => {
  const app = await AppPage.open({ bench: { granted: true } });
  const dialog = app.page.getByRole('dialog');
  const looked = async (what: string, out: string): Promise<void> => {
    await dialog.waitFor();
    await isWellMade(app, what);
    await dialog.getByRole('button', { name: out }).click();
    await dialog.waitFor({ state: 'hidden' });
  };
  await app.button('New program…').click();
  await looked('a new program', 'Cancel');
  await app.button('Connect').first().click();
  await app.hasRead();
  await app.page.keyboard.press('Control+k');
  await dialog.waitFor();
  await isWellMade(app, 'the list of commands');
  await app.page.keyboard.press('Escape');
  await app.showFigures();
  await isWellMade(app, 'the large figures');
  await app.button('Close the large figures').click();
  await app.goTo('Memories');
  await app.button('Read and keep all…').click();
  await looked('before all is read', 'Cancel');
  await app.goTo('Settings');
  await app.button(/^Delete/).click();
  await looked('before all is deleted', 'Cancel');
  await app.goTo('Program');
  await app.fly('M3');
  await app.button('Disconnect').click();
  await dialog.waitFor();
  await isWellMade(app, 'before another memory is left to fly next');
});

test('a disabled control looks disabled, in each theme', async () => {
  const app = await AppPage.open({ bench: {} });
  await app.connect();
  await app.bench((bench) => bench.adapter.unplug());
  await app.says('The adapter is unplugged.');
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
    const app = await AppPage.open({ bench: {} });
    const inEachLook = async (check: (look: string) => Promise<void>): Promise<void> => {
      for (const width of widths) {
        await app.resize({ width, height: 800 });
        for (const theme of ['light', 'sun']) {
          await showTheme(app, theme);
          await check(`${width} px, ${theme}`);
        }
      }
    };
    await inEachLook(() => app.expectNoSidewaysScrolling());
    await app.connect();
    await inEachLook(() => app.expectNoSidewaysScrolling());
    await app.type('Motor stop', '39.95');
    await app.type('Function 1 time', '1:30.25');
    await app.type('DT', '10:00');
    for (const servo of ['S1', 'S2', 'S3']) await app.type(`Function 2, ${servo}`, '130');
    await inEachLook(async (look) => {
      await app.expectNoSidewaysScrolling();
      expect(await app.page.evaluate(hidden), look).toEqual([]);
    });
  });

  test('in a table of many servos, an old value and the new one', async () => {
    const app = await AppPage.open({
      viewport: { width: 1366, height: 800 },
      bench: { granted: true, identity: { functions: 20, servos: 8 } },
    });
    await app.connect();
    await app.type('Function 19 time', '1:30.25');
    await app.type('DT time', '10:00');
    await app.type('Function 9, S1', '120');
    await app.page.locator('.old-value').nth(2).waitFor();
    expect(await app.page.evaluate(hidden)).toEqual([]);
  });

  test('at 320 px, during a reading over a disturbed line', async () => {
    const app = await AppPage.open({ viewport: { width: 320, height: 800 }, bench: { damage: 0.1 } });
    await app.button('Connect').click();
    await app.text(/The line is disturbed\./).waitFor();
    await app.expectNoSidewaysScrolling();
  });
});
