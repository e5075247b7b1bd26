// Takes the pictures of docs/ from the built page, with the simulated timer. To be run again when the screen has changed:
// npm run build && node test/tools/pictures.js
// Names of states as arguments take only these.

import { mkdirSync, writeFileSync } from 'node:fs';
import { chromium } from 'playwright';
import { launchOptions } from './browser.js';
import { serve } from './serve.js';

/** @typedef {import('playwright').Page} Page */

const folder = new URL('../../docs/screens/', import.meta.url);
const sizes = { desktop: { width: 1280, height: 800 }, phone: { width: 390, height: 844 } };
const themes = /** @type {const} */ (['light', 'dark', 'sun']);

/** @param {Page} page @param {string | RegExp} name */
const press = (page, name) => page.getByRole('button', { name }).first().click();

/** @param {Page} page @param {string} field @param {string} text */
async function enter(page, field, text) {
  const box = page.getByRole('textbox', { name: field, exact: true });
  await box.fill(text);
  await box.press('Enter');
}

/** @param {Page} page @param {string} title */
async function open(page, title) {
  const summary = page.locator('summary', { hasText: title }).first();
  await summary.click();
  await summary.evaluate((element) => element.scrollIntoView({ block: 'start' }));
  await page.evaluate(() => scrollBy(0, -80));
}

/** @param {Page} page */
const toTop = (page) => page.evaluate(() => scrollTo(0, 0));

/** @param {Page} page */
const settled = (page) => page.locator('button:enabled', { hasText: /^Read again$/ }).waitFor();

/** @param {Page} page */
async function connect(page) {
  await press(page, 'Try a simulated F1Q timer');
  await settled(page);
}

/** @param {Page} page */
async function change(page) {
  await connect(page);
  await enter(page, 'DT', '6:00');
  await enter(page, 'Function 4, S2', '70');
  await toTop(page);
}

/** @param {Page} page */
async function review(page) {
  await change(page);
  await press(page, 'Write…');
  await page.getByRole('dialog').waitFor();
}

/** @param {Page} page */
const promise = (page) =>
  page
    .getByRole('checkbox', { name: /^The propeller/ })
    .first()
    .check();

/** @param {Page} page */
async function follow(page) {
  await connect(page);
  await open(page, 'Bench');
  await promise(page);
  await page.getByRole('switch').click();
  await page.getByRole('switch', { checked: true }).waitFor();
  await enter(page, 'Function 4, S1', '60');
  await page.getByText('Tried: 1 position').first().waitFor();
}

/** What the pages show, in the order of docs/screens.md. @type {Readonly<Record<string, (page: Page) => Promise<void>>>} */
const states = {
  start: async (page) => {
    await page.getByRole('button', { name: 'Connect' }).first().waitFor();
  },
  program: connect,
  changed: change,
  field: async (page) => {
    await change(page);
    await page.getByRole('textbox', { name: 'Function 4, S2', exact: true }).click();
  },
  checks: async (page) => {
    await connect(page);
    await enter(page, 'Function 3 time', '10.5');
    await enter(page, 'Function 5, S1', '999');
    await enter(page, 'DT', '0:50');
    await page.getByRole('heading', { name: 'Checks' }).scrollIntoViewIfNeeded();
  },
  shift: async (page) => {
    await connect(page);
    await open(page, 'Shift in time');
  },
  paste: async (page) => {
    await connect(page);
    await page.getByRole('textbox', { name: 'Function 2, S1', exact: true }).click();
    await page.evaluate(() => {
      const clipboardData = new DataTransfer();
      clipboardData.setData('text/plain', '40\t41\t42\n50\tup\t52');
      document.activeElement?.dispatchEvent(
        new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }),
      );
    });
    await page.getByRole('dialog').waitFor();
  },
  presets: async (page) => {
    await connect(page);
    await press(page, 'Change presets');
  },
  write: review,
  verified: async (page) => {
    await review(page);
    await promise(page);
    await page
      .getByRole('dialog')
      .getByRole('button', { name: /^Write/ })
      .click();
    await page
      .getByRole('dialog')
      .getByText(/verified/i)
      .first()
      .waitFor();
  },
  preview: async (page) => {
    await connect(page);
    await open(page, 'Flight preview');
  },
  bench: async (page) => {
    await connect(page);
    await open(page, 'Bench');
    await promise(page);
    await press(page, 'Next function');
    await page.getByText('Servos at start').waitFor();
  },
  following: follow,
  tried: async (page) => {
    await follow(page);
    await page.getByRole('switch').click();
    await page.getByRole('button', { name: 'Keep it' }).first().waitFor();
    await settled(page);
  },
  memories: async (page) => {
    await connect(page);
    await open(page, 'Memories side by side');
    await press(page, 'Read all…');
    await page.getByRole('dialog').getByRole('button', { name: 'Back up' }).click();
    await page.getByText('were read and kept').waitFor();
    await page.getByRole('dialog').getByRole('button', { name: 'Close' }).click();
    await settled(page);
  },
  disconnected: async (page) => {
    await change(page);
    await press(page, 'Disconnect');
    await page.getByText('2 changes').waitFor();
  },
};

const only = process.argv.slice(2);
const server = await serve();
const browser = await chromium.launch(launchOptions());
mkdirSync(folder, { recursive: true });
for (const [name, reach] of Object.entries(states)) {
  if (only.length > 0 && !only.includes(name)) continue;
  for (const [size, viewport] of Object.entries(sizes)) {
    for (const theme of themes) {
      const context = await browser.newContext({ viewport, hasTouch: size === 'phone', reducedMotion: 'reduce' });
      const page = await context.newPage();
      await page.addInitScript((chosen) => localStorage.setItem('sidus-timer/theme', JSON.stringify(chosen)), theme);
      await page.goto(server.url);
      await reach(page);
      const devtools = await context.newCDPSession(page);
      const { data } = await devtools.send('Page.captureScreenshot', { format: 'webp', quality: 60 });
      writeFileSync(new URL(`${name}-${size}-${theme}.webp`, folder), Buffer.from(data, 'base64'));
      await context.close();
    }
  }
  console.log(name);
}
await browser.close();
await server.close();
