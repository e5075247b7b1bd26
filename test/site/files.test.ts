import { expect, inject, test } from 'vitest';
import { formatLibraryFile, type Library, parseLibraryFile } from '../../src/program/index.js';
import { FLIGHT, MODEL, SETTING } from '../program/library-examples.js';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { chooseFile, downloadedBy } from './library.js';
import { newPage } from './page.js';

const LIBRARY: Library = { models: [MODEL], settings: [SETTING], flights: [FLIGHT] };
const TEXT = formatLibraryFile(LIBRARY, { writtenAt: Date.UTC(2026, 10, 1), writtenBy: 'a test' });

async function takeAll(app: AppPage): Promise<void> {
  await app.button('Import 3').click();
  await app.text(/^Imported from .*: 1\smodel, 1\sprogram, 1\sflight\.$/).waitFor();
}

test('what did not come of the page comes when the pilot tries again', async () => {
  const faults: string[] = [];
  const page = await newPage({ serviceWorkers: 'block' }, faults);
  let isGone = true;
  await page.route(/\/all-else-[^/]*\.js$/, (route) => (isGone ? route.abort() : route.continue()));
  await page.goto(inject('site'));
  await page.getByText(en.parts.failed).waitFor();
  isGone = false;
  await page.getByRole('button', { name: en.parts.again }).click();
  await page.getByText(en.parts.failed).waitFor({ state: 'detached' });
  await new AppPage(page).hasParts();
  expect(new Set(faults)).toEqual(new Set(['Failed to load resource: net::ERR_FAILED']));
});

test('a dropped file does not replace the page, and the list of commands has Import and Export', async () => {
  const app = await AppPage.open({ acceptDownloads: true });
  const { page } = app;
  await page.evaluate(() => location.assign('#library'));
  await app.button('Import…').waitFor();
  const address = page.url();
  await page.evaluate((text) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([text], 'dropped.sidus'));
    for (const type of ['dragover', 'drop'])
      document.body.dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer }));
  }, TEXT);
  await page.getByRole('heading', { name: en.files.import.title({ name: 'dropped.sidus' }) }).waitFor();
  await app.button('Cancel').click();
  expect(page.url()).toBe(address);

  await app.goTo('Settings');
  const command = async (name: string): Promise<void> => {
    await page.keyboard.press('Control+k');
    await page.getByRole('combobox', { name: en.palette.search }).fill(name);
    await page.keyboard.press('Enter');
  };
  await chooseFile(app, 'field.sidus.json', TEXT, () => command('import'));
  await takeAll(app);
  const { name, text } = await downloadedBy(app, () => command('export all'));
  expect(name).toMatch(/^Sidus library \d{4}-\d\d-\d\d\.sidus\.json$/);
  expect(parseLibraryFile(text).library).toEqual(LIBRARY);
});

test('a file that the system opens is shown', async () => {
  const app = await AppPage.open({
    before: () => {
      let consumer: (launch: { files: FileSystemFileHandle[] }) => void;
      Object.assign(window, {
        openWith: async (text: string) => {
          const root = await navigator.storage.getDirectory();
          const handle = await root.getFileHandle('sent.sidus', { create: true });
          const stream = await handle.createWritable();
          await stream.write(text);
          await stream.close();
          consumer({ files: [handle] });
        },
      });
      Object.defineProperty(window, 'launchQueue', {
        value: {
          setConsumer: (given: typeof consumer) => {
            consumer = given;
          },
        },
      });
    },
  });
  const { page } = app;
  await app.hasParts();
  await page.evaluate((text) => (window as unknown as { openWith(text: string): Promise<void> }).openWith(text), TEXT);
  await page.getByRole('heading', { name: en.files.import.title({ name: 'sent.sidus' }) }).waitFor();
  await takeAll(app);
});
