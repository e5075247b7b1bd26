import { describe, expect, test } from 'vitest';
import { parseCapture } from '../../src/protocol/index.js';
import { en } from '../tools/en.js';
import { AppPage, FIRST_POSITIONS } from './app-page.js';
import { chooseFile, downloadedBy } from './library.js';

const { send, ...words } = en.line;

/** A pilot who has read the timer and opened the line. */
async function opened(options: Parameters<typeof AppPage.open>[0] = {}): Promise<AppPage> {
  const app = await AppPage.connected(options);
  await app.openLine();
  return app;
}

describe('the line', () => {
  test('can be saved, loaded and replayed as a timer, within the rules of the page', async () => {
    const app = await opened({ acceptDownloads: true });
    await app.goTo('Program');
    await app.type('DT time', '6:00');
    await app.write();
    await app.result('Verified.');
    await app.close();
    await app.goTo('Line');
    const { name, text } = await downloadedBy(app, () => app.button('Save').click());
    expect(name).toBe('sidus-line-Q536.txt');
    expect(parseCapture(text).length).toBeGreaterThan(10);
    await app.button('Disconnect').click();

    await chooseFile(app, 'field.txt', text, () => app.button(words.load).click());
    await app.text('field.txt: a recording of').waitFor();
    await app.button(words.replay).click();
    await app.goTo('Program');
    await app.hasRead();
    await app.page.getByRole('banner').getByText('simulated').waitFor();
    for (const servo of ['S1', 'S2', 'S3']) await expect.poll(() => app.positions(servo)).toEqual(FIRST_POSITIONS);
    await expect.poll(() => app.valueOf('DT time')).toBe('3:00');
  });
});

describe('a frame by hand', () => {
  test('goes out once after a tick and a yes, and the program is read again', async () => {
    const app = await opened();
    await app.text(send.title).click();
    await app.field(send.bytes).fill('63 04 01 46');
    // A double click: the second click does not count as the yes.
    await app.button(send.send).dblclick();
    const dialog = app.page.getByRole('dialog', { name: send.confirmTitle });
    await dialog.waitFor();
    await app.page.keyboard.press('Enter');
    expect(await app.bench((bench) => bench.sets)).toEqual([]);
    await dialog.getByLabel(en.write.safety).check();
    await app.button(send.confirm).click();
    await app.goTo('Program');
    await expect.poll(() => app.valueOf('Function 4, S2')).toBe('70');
    expect(await app.bench((bench) => bench.sets)).toEqual(['SETSERVO']);
  });
});
