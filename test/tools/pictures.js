// Takes the pictures of docs/screens from the built page, and writes docs/screens.md, which shows them. To be run again when the
// screen has changed: npm run build && node test/tools/pictures.js
// Names of states as arguments take only these.

import { mkdirSync, writeFileSync } from 'node:fs';
import { chromium } from 'playwright';
import { launchOptions } from './browser.js';
import { states } from './picture-states.js';
import { serve } from './serve.js';
import { workbenchScript } from './workbench-script.js';

/** @typedef {import('./picture-states.js').State} State */

const folder = new URL('../../docs/screens/', import.meta.url);
const sizes = { desktop: { width: 1280, height: 800 }, phone: { width: 390, height: 844 } };
const themes = /** @type {const} */ (['light', 'dark', 'sun']);

const only = process.argv.slice(2);
const server = await serve();
const browser = await chromium.launch(launchOptions());
const workbench = await workbenchScript();
mkdirSync(folder, { recursive: true });
for (const [name, { reach, bench }] of Object.entries(states)) {
  if (only.length > 0 && !only.includes(name)) continue;
  for (const [size, viewport] of Object.entries(sizes)) {
    for (const theme of themes) {
      const context = await browser.newContext({ viewport, hasTouch: size === 'phone', reducedMotion: 'reduce' });
      const page = await context.newPage();
      await page.addInitScript((chosen) => localStorage.setItem('sidus-timer/theme', JSON.stringify(chosen)), theme);
      if (bench) {
        await page.addInitScript((given) => {
          window.workbenchOptions = given;
        }, bench);
        await page.addInitScript(workbench);
      }
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
writeFileSync(new URL('../screens.md', folder), album());

/** All pictures, a table for each state. */
function album() {
  const capital = (/** @type {string} */ word) => word.replace(/^./, (letter) => letter.toUpperCase());
  const row = (/** @type {string} */ name, /** @type {State} */ { title }, /** @type {string} */ size) =>
    themes.map((theme) => `![${title}, ${size}, ${theme}](screens/${name}-${size}-${theme}.webp)`).join(' | ');
  const tables = Object.entries(states).map(
    ([name, state]) => `## ${state.title}

|  | ${themes.map(capital).join(' | ')} |
| --- |${' --- |'.repeat(themes.length)}
${Object.keys(sizes)
  .map((size) => `| ${capital(size)} | ${row(name, state, size)} |`)
  .join('\n')}
`,
  );
  return `# The page, state by state

Taken from the built page on a desktop (1280 x 800) and a phone (390 x 844), in light, dark and sun colours, with a simulated timer: the one
that is built in, or one behind a simulated adapter where cables are pulled. \`npm run build && node test/tools/pictures.js\` takes them
again, and writes this page.

${tables.join('\n')}`;
}
