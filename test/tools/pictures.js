// Takes the pictures of docs/ from the built page. To be run again when the screen has changed: npm run build && node test/tools/pictures.js

import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright';
import { launchOptions } from './browser.js';
import { serve } from './serve.js';

const server = await serve();
const browser = await chromium.launch(launchOptions());

/**
 * @param {string} name
 * @param {import('playwright').BrowserContextOptions} options
 */
async function program(name, options) {
  const page = await browser.newPage(options);
  await page.goto(server.url);
  await page.getByRole('button', { name: 'Try a simulated F1Q timer' }).click();
  await page.getByLabel('DT', { exact: true }).fill('6:00');
  await page.getByLabel('Function 4, S2').fill('70');
  await page.getByLabel('Function 4, S2').blur();
  await page.getByText('2 changes').waitFor();
  await page.evaluate(() => scrollTo(0, 0));
  await page.screenshot({ path: fileURLToPath(new URL(`../../docs/${name}.png`, import.meta.url)) });
  await page.close();
}

await program('program', { viewport: { width: 1280, height: 800 }, colorScheme: 'light' });
await program('program-phone', { viewport: { width: 390, height: 844 }, colorScheme: 'dark' });
await browser.close();
await server.close();
