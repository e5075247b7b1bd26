import { expect, test } from 'vitest';
import { meant, readCsv } from '../app/flights/csv-reader.js';
import { en } from '../tools/en.js';
import { sentencesIn } from '../tools/spoken.js';
import { AppPage } from './app-page.js';
import { contestDay, downloadedBy, fillLibrary } from './library.js';
import { PHONE } from './page.js';
import { pagesOf } from './pdf.js';

test('a flight is logged with one tap, filled in, kept, found again and exported; a short DT is put back', async () => {
  const app = await AppPage.open({ locale: 'en-GB', timezoneId: 'Europe/Budapest' });
  const { page } = app;
  await app.trySimulated('F1Q');
  await app.type('DT time', '20 s');
  await app.write();
  await app.result('Verified.');
  await app.dialog.getByText(/^M1\sverified\s\d\d:\d\d\s· DT\s20\ss\s· motor\sstop\s10\.0\ss/).waitFor();
  await app.button('Flying this').click();
  await app.dialog.getByText(/^Flight\slogged\s\d\d:\d\d/).waitFor();
  // What is typed after the flight does not belong to it.
  await app.button('Fill in').click();
  const form = page.getByRole('dialog', { name: 'Flight' });
  await form.getByRole('textbox', { name: 'Result' }).fill('0:19,5');
  await form.getByRole('button', { name: 'Wind: more' }).click();
  await form.getByRole('textbox', { name: 'Temperature °C' }).fill('-2,5');
  await form.getByRole('textbox', { name: 'Note' }).fill('=1+1, trimmed; "left"');
  await form.getByText(en.flights.form.when).click();
  await form.getByRole('combobox', { name: 'Place' }).fill('Gyula');
  await form.getByRole('button', { name: 'Done' }).click();
  await form.waitFor({ state: 'hidden' });
  const focused = (): Promise<string | null | undefined> => page.evaluate(() => document.activeElement?.textContent);
  await expect.poll(focused, { message: 'the dialog that led to the form has closed, too' }).toBe('Write…');

  // The pilot disconnects, and would fly with a DT for trimming.
  await app.button('Disconnect').click();
  const leave = page.getByRole('dialog', { name: en.nextFlight.leaving.title });
  await leave.getByText('DT of M1 is 20 s. Put it back to 3:00 min?').waitFor();
  await leave.getByRole('button', { name: 'Put DT back to 3:00 min…' }).click();
  await app.dialog.waitFor();
  await expect.poll(() => app.difference()).toEqual(['DT | 20 s | 3:00 min']);
  await app.dialog.getByRole('button', { name: 'Write 1 change' }).click();
  await app.result('Verified.');
  await app.dialog.getByText(/^M1\sverified\s\d\d:\d\d\s· DT\s3:00\smin/).waitFor();
  await app.dialog.getByRole('button', { name: 'Flying this' }).click();
  await app.dialog.getByRole('button', { name: 'Disconnect' }).click();
  await app.button('Connect').waitFor();

  await app.reload();
  await page.evaluate(() => location.assign('#library/flights'));
  const rows = page.locator('.flight-row');
  await rows.nth(1).waitFor();
  await expect.poll(() => rows.count()).toBe(2);
  await page.getByText('2 flights', { exact: true }).first().waitFor();
  const trimmed = rows.filter({ hasText: 'DT 20 s' });

  const { name, text } = await downloadedBy(app, () => app.button(en.flights.csv.save).click());
  expect(name).toMatch(/^flights-\d{4}-\d\d-\d\d\.csv$/);
  expect(text[0], 'the file begins with the mark by which Excel knows UTF-8').toBe('\ufeff');
  const [head = [], ...saved] = readCsv(text.slice(1), ',');
  expect(saved.length).toBe(2);
  const row = saved.find((each) => each[head.indexOf('DT (s)')] === '20') ?? [];
  const cells = Object.fromEntries(head.map((name, at) => [name, row[at]]));
  expect(cells).toMatchObject({
    Place: 'Gyula',
    'DT (s)': '20',
    [en.flights.csv.columns.motorStop]: '10',
    Memory: '1',
    'Wind (m/s)': '2',
    [en.flights.csv.columns.temperature]: '-2.5',
    'Result (s)': '19.5',
  });
  const { Note: note = '' } = cells;
  expect([note, meant(note)]).toEqual([`'=1+1, trimmed; "left"`, '=1+1, trimmed; "left"']);

  await trimmed.click();
  await form.getByText(en.flights.form.flown).click();
  const flown = form.getByRole('table', { name: en.program.tableCaption });
  await expect
    .poll(() => flown.getByRole('row', { name: /^DT/ }).innerText(), { message: 'a copy, whatever was written since' })
    .toContain('20 s');
  await form.getByRole('button', { name: 'Delete' }).click();
  await trimmed.waitFor({ state: 'detached' });
  await page.getByRole('button', { name: 'Undo', exact: true }).first().click();
  await trimmed.waitFor();
});

test.each([
  ['desktop', {}],
  ['phone', PHONE],
])('on a %s a contest day becomes a card with its maxima, which is copied and printed', async (_, size) => {
  const permissions = ['clipboard-read', 'clipboard-write'];
  const app = await AppPage.open({ ...size, locale: 'de-AT', permissions });
  const { page } = app;
  await fillLibrary(app, { models: [], settings: [], flights: contestDay() });
  await page.evaluate(() => location.assign('#library/flights'));
  await app.reload();
  const { copied, flights: said } = await sentencesIn('de');
  const { score: words, csv, row: facts } = said;
  const maximumOf = (round: string) => app.field(words.maximumOf({ round: facts.round({ round }) }));
  await app.button(words.open).click();
  await app.field(words.maximum).click();
  await page.keyboard.type("3'00");
  await page.keyboard.press('Enter');
  await expect.poll(() => maximumOf('2').inputValue()).toBe('180');
  await maximumOf('1').fill('4:00');
  // Leaving the field by a tap elsewhere takes it.
  await app.button(words.count).click();
  const totalRow = page.getByRole('row', { name: words.total });
  await totalRow.getByText('390', { exact: true }).waitFor();
  await app.button(words.count).click();
  const total = totalRow.getByText('411,5', { exact: true });
  await total.waitFor();
  await app.button(words.copy).click();
  await page.getByText(copied).waitFor();
  expect((await page.evaluate(() => navigator.clipboard.readText())).split(/\r?\n/)).toEqual([
    'Sa., 2. Mai 2026',
    'Gyula',
    'Lancer',
    '',
    [csv.columns.round, csv.columns.result, csv.columns.maximum, words.counted].join('\t').replaceAll(/ \([^\t]*/g, ''),
    '1\t240\t240\t240',
    `2\t150\t\t${words.notCounted}`,
    '2\t171,5\t180\t171,5',
    `3\t\t180\t${facts.noResult}`,
    `${words.total}\t\t\t411,5`,
    'Fly-off\t300\t\t300',
  ]);
  const [paper, ...more] = await pagesOf(await page.pdf());
  expect(more.length, 'a day is on one page').toBe(0);
  for (const shown of [words.total, '411,5', 'Gyula']) expect(paper?.text).toContain(shown);
  expect(paper?.text).not.toContain(words.copy);

  await app.reload();
  await app.button(words.open).click();
  await total.waitFor();
  await expect.poll(() => maximumOf('1').inputValue()).toBe('240');
});

test('a log of 1,000 flights is scrolled to its end, where one is changed', async () => {
  const app = await AppPage.open();
  const { page } = app;
  const identity = { timerClass: 'B', firmware: '536', functions: 2, memories: 4, servos: 1 };
  const program = { identity, memory: 0, times: [0, 100, 18_000], positions: [[1, 2, 3]], idleThrottle: null };
  const nothing = { place: '', model: null, modelName: '', setting: null, settingName: '', round: '', note: '' };
  const flights = Array.from({ length: 1000 }, (_, at) => {
    const flight = { id: `f${at}`, at: at * 3_600_000, program, ...nothing, wind: null, temperature: null, result: at };
    return { key: flight.id, flight, changedAt: 0 };
  });
  await fillLibrary(app, { models: [], settings: [], flights });
  await page.evaluate(() => location.assign('#library/flights'));
  await app.reload();
  const rows = page.locator('.flight-row');
  await page.getByText('1000 flights', { exact: true }).first().waitFor();
  await rows.filter({ hasText: '16:39 min' }).waitFor();
  const oldest = rows.filter({ hasText: /No model\s*0 s$/ });
  await page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight));
  await oldest.click();
  const form = page.getByRole('dialog', { name: 'Flight' });
  await form.getByRole('textbox', { name: 'Result' }).fill('0,5 s');
  await page.keyboard.press('Enter');
  await form.waitFor({ state: 'hidden' });
  await rows.filter({ hasText: '0.5 s' }).waitFor();
});
