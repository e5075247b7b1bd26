import { expect, test } from 'vitest';
import { PAPERS, type Paper } from '../../src/app/print/print-order.js';
import { encodeLink, LINK_MARK, type SharedSetting } from '../../src/program/index.js';
import { programOf } from '../app/programs.js';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { type PdfPage, pagesOf } from './pdf.js';
import { textOfCode } from './qr.js';

const wide = (name: string, functions: number, servos: number, note = '', modelName = 'Lancer 07'): SharedSetting => ({
  name,
  note,
  at: 1_795_000_000_000,
  tags: [],
  modelName,
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
const SETTINGS = [
  wide('usual', 10, 3, 'calm'),
  wide('wide', 20, 8, NOTE),
  wide('long', 60, 2),
  wide('widest', 12, 12, '', 'Magpie 3'),
];

const solid = (text: string): string => text.replace(/\s/g, '');

/** What is printed, without spaces: those of a table are only distances. */
async function solidPages(app: AppPage): Promise<readonly PdfPage[]> {
  const pages = await pagesOf(await app.page.pdf({ preferCSSPageSize: true }));
  return pages.map(({ size, text }) => ({ size, text: solid(text) }));
}

test('sheets of several programs: each page names its model, and every row is on one, on each paper', async () => {
  const app = await AppPage.open();
  for (const setting of SETTINGS) {
    await app.page.evaluate((to) => void location.assign(to), LINK_MARK + encodeLink(setting));
    await app.button(en.share.received.keep).click();
  }
  await app.page.evaluate(() => location.assign('#print'));
  for (const { name } of SETTINGS) await app.page.getByRole('checkbox', { name: new RegExp(`${name}$`) }).check();
  const sizes: Readonly<Record<Paper, string>> = { a5: '148x210', a4: '210x297', letter: '216x279' };
  for (const [paper, size] of Object.entries(sizes)) {
    await app.page.getByRole('radio', { name: PAPERS[paper as Paper], exact: true }).check({ force: true });
    // Waits for the fonts: they may come later than the print.
    await app.page.evaluate(() => document.fonts.ready);
    const pages = await solidPages(app);
    expect([...new Set(pages.map((page) => page.size))], paper).toEqual([size]);
    const printed = SETTINGS.map(({ name, modelName, program }) => {
      const own = pages.filter(({ text }) => text.includes(solid(`${modelName} · ${name} · M1`)));
      const said = own.map(({ text }) => text).join('');
      const rows = program.times.slice(1, -1).flatMap((_, at) => {
        const positions = program.positions.map((row) => String(row[at + 1]));
        const half = Math.ceil(positions.length / Math.ceil(positions.length / 8));
        return [positions.slice(0, half), positions.slice(half)]
          .filter(({ length }) => length > 0)
          .map((part) => ({
            row: `Function${at + 1}`,
            part: part.join(''),
          }));
      });
      return {
        name,
        pages: own.length,
        lost: rows.filter(({ row, part }) => !new RegExp(`${row}[\\d.:smin]+?${part}`).test(said)),
      };
    });
    expect(
      printed.map(({ name, lost }) => [name, lost]),
      paper,
    ).toEqual(SETTINGS.map(({ name }) => [name, []]));
    expect(printed[0]?.pages, `${paper}: a usual sheet is one page`).toBe(1);
    expect(
      printed.reduce((sum, each) => sum + each.pages, 0),
      `${paper}: no page is of nobody, or of two`,
    ).toBe(pages.length);
    expect(pages.filter(({ text }) => text.includes('lastline')).length, paper).toBe(1);
  }
});

test('the print view prints what the browser offers', async () => {
  const app = await AppPage.open({
    before: () => {
      window.print = () => document.body.setAttribute('data-printed', '');
    },
  });
  await app.trySimulated('F1Q');
  await app.page.evaluate(() => location.assign('#print'));
  await app.page.locator('.leaf').getByRole('row', { name: /^DT/ }).waitFor();
  await app.button(en.views.print).click();
  await expect.poll(() => app.page.locator('body[data-printed]').count()).toBe(1);
});

test('a view is printed black on white, below what it shows, without its commands and a picture that would be cut', async () => {
  const app = await AppPage.simulated({ colorScheme: 'dark' });
  await app.page.emulateMedia({ media: 'print', colorScheme: 'dark' });
  const shown = (...parts: readonly string[]): Promise<boolean[]> =>
    Promise.all(parts.map((each) => app.page.locator(each).isVisible()));
  expect(await shown('.strip .badge', '.strip-figures', '.table-box')).toEqual([true, true, true]);
  const left = ['.view-links', '.actions', '.strip .top-actions', '.timeline'];
  expect(await shown(...left)).toEqual(left.map(() => false));
  const inks = (): Promise<string[]> =>
    app.page.evaluate(() =>
      ['color', 'background-color'].map((each) => getComputedStyle(document.body).getPropertyValue(each)),
    );
  const [ink = '', ground] = await inks();
  expect([Math.max(...(ink.match(/\d+/g) ?? []).map(Number)) < 64, ground]).toEqual([true, 'rgba(0, 0, 0, 0)']);
});

test('the QR code on a sheet is read back, and brings the program', async () => {
  // About as fine as a printer.
  const app = await AppPage.simulated({ deviceScaleFactor: 3 });
  await app.type('DT time', '4:10');
  await app.page.evaluate(() => location.assign('#print'));
  await app.page.getByRole('checkbox', { name: en.print.parts.code }).check();
  const buffer = await app.page.locator('.leaf-code .qr-code').screenshot();
  const reader = await app.sibling();
  await reader.page.goto(await textOfCode(app.page, buffer));
  const shown = reader.page.getByRole('dialog', { name: en.share.received.title });
  await expect.poll(() => shown.getByRole('row', { name: /^DT/ }).innerText()).toContain('4:10');
});
