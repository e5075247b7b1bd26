import { expect, test } from 'vitest';
import { parseTime } from '../../src/app/editing/units.js';
import { en } from '../../src/app/messages/en.js';
import { edits } from '../../src/app/messages/en-edits.js';
import { sheets } from '../app/editing/sheets.js';
import { AppPage } from './app-page.js';

/**
 * What other programs and people put on the clipboard, and how many changes it makes at function 1, and at
 * function 8 of S2.
 */
const HOSTILE: readonly { what: string; text: string; takes: [number, number] }[] = [
  {
    what: 'text in the place of numbers',
    text: '?\tich\tbin\tkein\tTimer\n12.5\tsoon\t?\t20\t-\n\t\tNaN\tInfinity\t\n',
    takes: [2, 0],
  },
  { what: 'gaps, ragged rows and empty lines', text: '\t\t70\n\n\n12,7\n\t71\t\t72\n\n', takes: [4, 0] },
  {
    what: 'a hundred slots',
    text: Array.from({ length: 100 }, (_, at) => String(11 + at)).join('\t'),
    takes: [4, 2],
  },
  {
    what: 'numbers beyond all measure',
    text: '1e309\t-1e309\t999999999999999999999\n0x7f\t1e2\t131\n655.36\t-1\t130.5\n11.1\t1\t2',
    takes: [3, 0],
  },
  {
    what: 'formulas and scripts',
    text: '=SUM(A1:A9)\t=HYPERLINK("http://x","y")\n+1\t@cmd\n<img src=x onerror=alert(1)>\t"12"\n#REF!\t1\'000\n',
    takes: [1, 1],
  },
  {
    what: 'a sheet with decimal commas, headings and names',
    text: 'Function\tTime\tS1\tS2\tS3\nF1\t11,25\t20\t21\t22\nF2\t12,5\t23\t24\t25',
    takes: [8, 8],
  },
  {
    what: 'more cells than are read',
    text: Array.from({ length: 5000 }, (_, at) => `${at % 131};${(at + 1) % 131};77`).join('\n'),
    takes: [30, 6],
  },
];

/** A pilot who copies from a spreadsheet, with the real clipboard of the browser. */
async function opened(): Promise<AppPage> {
  const app = await AppPage.open({ bench: {}, permissions: ['clipboard-read', 'clipboard-write'] });
  await app.connect();
  return app;
}

async function paste(app: AppPage, field: string, text: string): Promise<void> {
  await app.page.evaluate((copied) => navigator.clipboard.writeText(copied), text);
  await app.table.getByRole('textbox', { name: field, exact: true }).focus();
  await app.page.keyboard.press('Control+v');
}

type Changed = Readonly<Record<string, readonly unknown[]>>;

/** The values of two texts of a field, with or without units: the dialog adds units to times. */
const values = (name: string, texts: readonly string[]): unknown[] =>
  texts.map((text) => (name.endsWith(' time') ? parseTime(text) : text));

const changed = (before: Readonly<Record<string, string>>, after: Readonly<Record<string, string>>): Changed =>
  Object.fromEntries(
    Object.entries(before).flatMap(([name, from]) => {
      const to = after[name] ?? '';
      // Intervals follow from the times.
      return name.endsWith('interval') || from === to ? [] : [[name, values(name, [from, to])]];
    }),
  );

/** What the table of the dialog says that changes. */
async function promised(app: AppPage): Promise<Changed> {
  const cells = await app.page.getByRole('dialog', { name: 'Paste' }).evaluate((dialog) => {
    const heads = Array.from(dialog.querySelectorAll('thead th'), ({ textContent }) => textContent ?? '');
    return Array.from(dialog.querySelectorAll('tbody tr')).flatMap((row) => {
      const [name, ...texts] = Array.from(row.children);
      return texts.flatMap((cell, at) => {
        const from = cell.querySelector('small')?.textContent ?? '';
        const to = cell.firstChild?.textContent?.trim() ?? '';
        return from === '' ? [] : [{ row: name?.textContent ?? '', head: heads[at + 1] ?? '', from, to }];
      });
    });
  });
  return Object.fromEntries(
    cells.flatMap(({ row, head, from, to }) => {
      const name = head === 'Time' ? `${row} time` : `${row}, ${head}`;
      return head === 'After' ? [] : [[name, values(name, [from, to])]];
    }),
  );
}

/** Pastes twice at a field and cancels the first time. @returns how many changes were shown, and made. */
async function tried(app: AppPage, field: string, text: string): Promise<number> {
  const dialog = app.page.getByRole('dialog', { name: 'Paste' });
  const gone = (): Promise<void> => dialog.waitFor({ state: 'hidden' });
  const before = await app.entries();
  await paste(app, field, text);
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  await gone();
  await expect.poll(() => app.entries(), { message: 'Cancel pastes nothing' }).toEqual(before);
  await expect.poll(() => app.undo.isDisabled(), { message: 'after Cancel there is no step to undo' }).toBe(true);

  await paste(app, field, text);
  await dialog.getByText(/^(This|The rest) changes/).waitFor();
  const shown = await promised(app);
  const take = dialog.getByRole('button', { name: /^Paste/ });
  if (await take.isDisabled()) await app.page.keyboard.press('Escape');
  else await take.click();
  await gone();
  await expect.poll(async () => changed(before, await app.entries())).toEqual(shown);
  const count = Object.keys(shown).length;
  if (count === 0) return 0;
  await app.undo.click();
  await expect.poll(() => app.entries()).toEqual(before);
  await expect.poll(() => app.undo.isDisabled(), { message: 'the whole paste is one step of undo' }).toBe(true);
  return count;
}

test('a paste changes nothing when cancelled, and exactly what was shown when confirmed', async () => {
  const app = await opened();
  for (const { what, text, takes } of HOSTILE) {
    expect([await tried(app, 'Function 1 time', text), await tried(app, 'Function 8, S2', text)], what).toEqual(takes);
  }
});

test('a range is copied in the form of a spreadsheet, and a paste at the same place restores it', async () => {
  const app = await opened();
  const before = await app.entries();
  await app.table.getByRole('textbox', { name: 'Function 2 time', exact: true }).focus();
  for (let i = 0; i < 3; i++) await app.page.keyboard.press('Shift+ArrowDown');
  for (let i = 0; i < 4; i++) await app.page.keyboard.press('Shift+ArrowRight');
  await app.text('4 functions, 5 columns').waitFor();
  await app.page.keyboard.press('Control+c');
  const copied = await app.page.evaluate(() => navigator.clipboard.readText());
  expect(copied.split('\n').map((row) => row.split('\t'))).toEqual([
    ['11.00', '35', '35', '35'],
    ['11.50', '45', '45', '45'],
    ['12.00', '55', '55', '55'],
    ['12.50', '65', '65', '65'],
  ]);

  await app.type('Function 3 time', '11.7');
  for (const field of ['Function 2, S1', 'Function 4, S2', 'Function 5, S3']) await app.type(field, '0');
  await paste(app, 'Function 2 time', copied);
  const dialog = app.page.getByRole('dialog', { name: 'Paste' });
  await dialog.getByText('This changes 4 values.').waitFor();
  await dialog.getByRole('button', { name: 'Paste' }).click();
  await dialog.waitFor({ state: 'hidden' });
  await expect.poll(() => app.entries()).toEqual(before);
  await app.text(/^As in the timer, (read|verified) \d\d:\d\d$/).waitFor();
});

/** The row of the program with this name, without its intervals. */
const rowOf = async (app: AppPage, row: string): Promise<string[]> => {
  const entries = await app.entries();
  return [`${row} time`, `${row}, S1`, `${row}, S2`, `${row}, S3`].map((name) => entries[name] ?? '');
};

test('a sheet goes where its rows and columns say, wherever the cursor is', async () => {
  const app = await opened();
  const dialog = app.page.getByRole('dialog', { name: edits.pasting.apply });
  const take = async (): Promise<void> => {
    await dialog.getByRole('button', { name: edits.pasting.apply, exact: true }).click();
    await dialog.waitFor({ state: 'hidden' });
  };
  await paste(app, 'Function 4, S2', sheets.withMotorRow);
  await expect
    .poll(async () => new Set(await dialog.getByRole('rowheader').allInnerTexts()))
    .toEqual(new Set(['Motor stop', ...Array.from({ length: 9 }, (_, at) => `Function ${at + 1}`), 'DT']));
  await take();
  await expect.poll(() => rowOf(app, 'Function 9')).toEqual(['2:00', '63', '56', '88']);
  expect(await rowOf(app, 'DT')).toEqual(['3:00', '63', '95', '88']);
  expect((await app.entries())[en.program.motorStopTime]).toBe('10.0');

  await paste(app, 'DT time', sheets.transposed);
  await take();
  await expect.poll(() => rowOf(app, 'Function 4')).toEqual(['12.00', '71', '41', '56']);
  expect((await rowOf(app, 'Start')).slice(1)).toEqual(['60', '15', '40']);

  await paste(app, 'Function 2, S3', 'Zeit\tS1\n1,5\t20');
  const asked = dialog.getByLabel('“Zeit”');
  await asked.waitFor();
  expect(await dialog.getByRole('button', { name: edits.pasting.apply, exact: true }).isDisabled()).toBe(true);
  await asked.selectOption('time');
  await take();
  await expect.poll(() => rowOf(app, 'Function 2')).toEqual(['1.50', '20', '20', '42']);
});

test('a sheet as the page shows it for printing is copied and pasted back', async () => {
  const app = await opened();
  const before = await app.entries();
  await app.page.evaluate(() => {
    location.hash = '#print';
  });
  const table = app.page.locator('.leaf-table').first();
  await table.waitFor();
  await table.evaluate((element) => {
    getSelection()?.selectAllChildren(element.closest('.leaf-body') ?? element);
  });
  await app.page.keyboard.press('Control+c');
  const copied = await app.page.evaluate(() => navigator.clipboard.readText());
  expect(copied).toMatch(/\nFunction\tTime\tAfter\tS1 *\tS2 *\tS3/);
  await app.page.goBack();
  for (const field of ['Function 2, S1', 'Function 9, S2', 'DT time', en.program.motorStopTime]) {
    await app.type(field, field.endsWith('time') ? '40 s' : '0');
  }
  await paste(app, 'Function 5, S3', copied);
  const dialog = app.page.getByRole('dialog', { name: edits.pasting.apply });
  await expect.poll(() => dialog.innerText()).toContain(edits.pasting.lead(4));
  await dialog.getByRole('button', { name: edits.pasting.apply, exact: true }).click();
  await dialog.waitFor({ state: 'hidden' });
  await expect.poll(() => app.entries()).toEqual(before);
});
