import { expect, test } from 'vitest';
import { share } from '../../src/app/messages/en-share.js';
import { encodeLink, LINK_MARK, type SharedSetting } from '../../src/program/index.js';
import { programOf } from '../app/programs.js';
import { AppPage } from './app-page.js';
import { PHONE } from './page.js';
import { textOfCode } from './qr.js';

const wide = (name: string, functions: number, servos: number, note = ''): SharedSetting => ({
  name,
  note,
  at: 1_795_000_000_000,
  tags: [],
  modelName: 'Lancer 07',
  program: programOf(
    'Q',
    Array.from({ length: functions + 1 }, (_, slot) => (slot === functions ? 36_000 : 50 + slot * 38)),
    Array.from({ length: servos }, (_, servo) =>
      Array.from({ length: functions + 1 }, (_, slot) => (servo * 7 + slot * 11) % 131),
    ),
  ),
});
const NOTE = `${'The tailplane was lowered by two steps because the model stalled. '.repeat(30)}\n${'x'.repeat(400)}\nlast line`;
/** The usual one; many servos with a long note; more functions than a page has rows. */
const SETTINGS = [wide('usual', 10, 3, 'calm'), wide('wide', 20, 8, NOTE), wide('long', 60, 2), wide('widest', 12, 12)];

/** What is outside its page, or cut by the edge. */
function outside(app: AppPage): Promise<string[]> {
  return app.page.evaluate(() =>
    [...document.querySelectorAll('.print-preview article')].flatMap((leaf) => {
      const body = leaf.querySelector('.leaf-body')?.getBoundingClientRect();
      const parts = leaf.querySelectorAll('.leaf-body :is(tr, p, h2, h3, svg, caption)');
      return [...parts].flatMap((part) => {
        const { top, bottom, left, right, width } = part.getBoundingClientRect();
        const isIn =
          body && top >= body.top - 1 && bottom <= body.bottom + 1 && left >= body.left - 1 && right <= body.right + 1;
        return isIn || width === 0 ? [] : [`${leaf.className}: ${part.outerHTML.slice(0, 90)}`];
      });
    }),
  );
}

/** The positions in the timelines whose first figure is struck through by their own line. */
function struckThrough(app: AppPage): Promise<string[]> {
  return app.page.locator('.print-preview .lane-position').evaluateAll((all) =>
    all.flatMap((each) => {
      const text = each as SVGTextElement;
      const line = text.parentElement?.querySelector<SVGPathElement>('.lane-line');
      const size = Number.parseFloat(getComputedStyle(text).fontSize);
      const { x, y } = text.getStartPositionOfChar(0);
      const isStruck = [0, 0.36, 0.72].some((height) =>
        line?.isPointInStroke(new DOMPoint(x + 0.3 * size, y - height * size)),
      );
      return isStruck ? [text.textContent] : [];
    }),
  );
}

/** The sizes of the pages in a PDF file, in millimetres. */
async function sizesOf(app: AppPage): Promise<string[]> {
  const file = (await app.page.pdf({ preferCSSPageSize: true })).toString('latin1');
  const pages = file.match(/\/Type\s*\/Page\b(?!s)/g)?.length ?? 0;
  const boxes = [...file.matchAll(/\/MediaBox\s*\[0 0 ([\d.]+) ([\d.]+)\]/g)].map((box) =>
    box
      .slice(1)
      .map((points) => Math.round((Number(points) / 72) * 25.4))
      .join('x'),
  );
  return [`${pages} pages`, ...new Set(boxes)];
}

test('sheets of several settings: every row on a page, as many pages as shown, on each paper', async () => {
  const app = await AppPage.open();
  for (const setting of SETTINGS) {
    await app.page.evaluate((to) => void location.assign(to), LINK_MARK + encodeLink(setting));
    await app.button('Keep in the library').click();
    await app.button('Show in the library').click();
  }
  await app.page
    .getByRole('link', { name: /Lancer 07/ })
    .first()
    .click();
  await app.button('Print…').first().click();
  const preview = app.page.getByRole('region', { name: 'Preview' });
  await preview.getByRole('heading', { name: 'Lancer 07' }).nth(3).waitFor();
  const papers = {
    A5: '148x210',
    A4: '210x297',
    Letter: '216x279',
    'A4, two to a page': '297x210',
    'Letter, two to a page': '279x216',
  };
  for (const [paper, size] of Object.entries(papers)) {
    await app.page.getByRole('radio', { name: paper, exact: true }).check();
    // Waits for the fonts: they may come later than the words.
    await app.page.evaluate(() => document.fonts.ready);
    const printed = async (): Promise<string[]> => {
      const shown = await preview.locator('.print-page').count();
      const [pages = '', ...sizes] = await sizesOf(app);
      return pages === `${shown} pages` ? sizes : [pages, `${shown} shown`];
    };
    await expect.poll(printed, { message: paper }).toEqual([size]);
    await app.page.emulateMedia({ media: 'print' });
    expect(await outside(app), paper).toEqual([]);
    expect(await struckThrough(app), paper).toEqual([]);
    // Each slot and the motor stop, once in each table of some servos.
    const tables = 2;
    await expect
      .poll(() => preview.locator('.leaf-table tbody tr').count(), { message: paper })
      .toBe(12 + 22 + 62 + tables * 14);
    await expect.poll(() => preview.getByText('last line').count()).toBe(1);
    await app.page.emulateMedia({ media: null });
  }
});

test('the print view is well made, on a phone too, and prints what the browser offers', async () => {
  for (const size of [{}, PHONE]) {
    const app = await AppPage.open({
      ...size,
      before: () => {
        window.print = () => document.body.setAttribute('data-printed', '');
      },
    });
    await app.trySimulated('F1Q');
    await app.page.evaluate(() => location.assign('#print'));
    await app.page.getByRole('region', { name: 'Preview' }).getByRole('row', { name: /^DT/ }).waitFor();
    await app.expectNoSidewaysScrolling();
    await app.button('Print 1 page…').click();
    await expect.poll(() => app.page.locator('body[data-printed]').count()).toBe(1);
  }
});

test('a view is printed black on white, below what it shows, and without its commands', async () => {
  const app = await AppPage.open({ colorScheme: 'dark' });
  await app.trySimulated('F1Q');
  await app.page.emulateMedia({ media: 'print', colorScheme: 'dark' });
  const shown = (): Promise<boolean[]> =>
    Promise.all(
      ['.strip .badge', '.strip-figures', '.table-box', '.view-links', '.actions', '.strip .top-actions'].map((each) =>
        app.page.locator(each).isVisible(),
      ),
    );
  expect(await shown()).toEqual([true, true, true, false, false, false]);
  const inks = (): Promise<string[]> =>
    app.page.evaluate(() =>
      ['color', 'background-color'].map((each) => getComputedStyle(document.body).getPropertyValue(each)),
    );
  const [ink = '', ground] = await inks();
  expect([Math.max(...(ink.match(/\d+/g) ?? []).map(Number)) < 64, ground]).toEqual([true, 'rgba(0, 0, 0, 0)']);
});

test('on a paper that is narrower than the window the timeline goes on to DT', async () => {
  const app = await AppPage.open();
  await app.trySimulated('F1Q');
  const reaches = (): Promise<boolean> =>
    app.page.locator('.timeline-room').evaluate((room) => {
      const side = room.closest<HTMLElement>('.program-side');
      if (!side) throw new Error('The timeline stands in no side.');
      // As a browser prints: nothing is drawn anew in between.
      side.style.width = '380px';
      const marks = [...room.querySelectorAll('.handle')].map((each) => each.getBoundingClientRect().right);
      const isIn = Math.max(...marks) <= room.getBoundingClientRect().right;
      side.style.width = '';
      return isIn;
    });
  expect(await reaches()).toBe(false);
  await app.page.emulateMedia({ media: 'print' });
  expect(await reaches()).toBe(true);
});

test('the QR code on a sheet is read back, and brings the setting', async () => {
  // About as fine as a printer.
  const app = await AppPage.open({ deviceScaleFactor: 3 });
  await app.trySimulated('F1Q');
  await app.type('DT time', '4:10');
  await app.page.evaluate(() => location.assign('#print'));
  await app.page.getByRole('checkbox', { name: 'QR code' }).check();
  const buffer = await app.page.locator('.print-page .leaf-code .qr-code').screenshot();
  const reader = await app.sibling();
  await reader.page.goto(await textOfCode(app.page, buffer));
  const shown = reader.page.getByRole('dialog', { name: share.received.title });
  await expect.poll(() => shown.getByRole('row', { name: /^DT/ }).innerText()).toContain('4:10');
});
