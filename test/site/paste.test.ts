import { expect, test } from 'vitest';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';

/** A pilot who copies from a spreadsheet, with the real clipboard of the browser. */
async function opened(): Promise<AppPage> {
  const app = await AppPage.connected({ permissions: ['clipboard-read', 'clipboard-write'] });
  return app;
}

async function paste(app: AppPage, field: string, text: string): Promise<void> {
  await app.page.evaluate((copied) => navigator.clipboard.writeText(copied), text);
  await app.table.getByRole('textbox', { name: field, exact: true }).focus();
  await app.page.keyboard.press('Control+v');
}

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
  const dialog = app.page.getByRole('dialog', { name: en.edits.pasting.apply });
  await expect.poll(() => dialog.innerText()).toContain(en.edits.pasting.lead({ count: 4 }));
  await dialog.getByRole('button', { name: en.edits.pasting.apply, exact: true }).click();
  await dialog.waitFor({ state: 'hidden' });
  await expect.poll(() => app.entries()).toEqual(before);
});
