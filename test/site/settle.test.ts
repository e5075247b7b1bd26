import { expect, test } from 'vitest';
import { parseCapture } from '../../src/protocol/index.js';
import { en } from '../tools/en.js';
import { AppPage } from './app-page.js';
import { downloadedBy } from './library.js';

const { bench } = en;

test('a walk with a timer of the other byte order settles what is so, keeps it, and leaves the timer as it was', async () => {
  const app = await AppPage.connected({ bench: { quirks: { bigEndianTimes: true } }, acceptDownloads: true });
  const before = await app.bench(({ content }) => JSON.stringify(content));
  await app.showAbout();
  await app.page.getByRole('link', { name: en.settle.title }).click();
  await app.page.getByRole('checkbox', { name: en.settle.safe }).check();
  await app.button(en.settle.readIt).click();
  await app.button(/^Function\s5\s12\.50\ss\s/).click();
  await app.button(en.settle.yes).click();
  await app.button('M1').click();
  await app.button(en.settle.ask).click();
  for (const [to, moved] of [
    ['DT', en.settle.no],
    ['function 1', en.settle.yes],
  ] as const) {
    await app.button(bench.bring({ slot: to })).click();
    await app.button(en.settle.tryIt).click();
    await app.text(en.settle.moved).waitFor();
    await app.button(moved).click();
  }
  await app.button(bench.unlock).hover();
  await app.page.mouse.down();
  await app.text(bench.unlocked).waitFor();
  await app.page.mouse.up();
  expect(await app.bench(({ content }) => JSON.stringify(content))).toBe(before);

  const { text } = await downloadedBy(app, () => app.button('Save').click());
  expect(parseCapture(text).length).toBeGreaterThan(50);
  expect(text).toContain(`# ${en.settle.names.order}: ${en.settle.no}`);
  await app.reload();
  await app.page.getByRole('main').getByRole('button', { name: 'Connect' }).click();
  await app.page.getByRole('checkbox', { name: en.settle.safe }).waitFor();
  await app.page.getByRole('link', { name: 'Settings', exact: true }).last().click();
  await app.text(en.aboutTimer.title).click();
  for (const name of Object.values({ ...en.settle.names, reserved: null })) {
    if (name) await app.text(`${name}:`).waitFor();
  }
});
