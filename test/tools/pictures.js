// Takes pictures of the built page: each state of picture-states.js on a desktop and a phone, in each theme.
//   npm run pictures              all of them, into dist/pictures with an index.html to look at
//   npm run pictures -- --docs    the few that README and docs show, into docs/pictures
//   npm run pictures -- --manifest    those for browsers that install the page, into public/screenshots
// Names of states as further arguments take only these. Needs a built page: npm run build:site

import { mkdirSync, writeFileSync } from 'node:fs';
import { chromium } from 'playwright';
import { launchOptions } from './browser.js';
import { inDocs, inManifest, states } from './picture-states.js';
import { serve } from './serve.js';
import { workbenchScript } from './workbench-script.js';

const sizes = { desktop: { width: 1280, height: 800 }, phone: { width: 390, height: 844 } };
const themes = /** @type {const} */ (['light', 'dark', 'sun']);

const only = process.argv.slice(2).filter((argument) => !argument.startsWith('--'));
/** The folder and the list of pictures, by their names there. */
const [place, chosen] = process.argv.includes('--manifest')
  ? ['../../public/screenshots/', new Map(Object.entries(inManifest).map(([name, picture]) => [picture, name]))]
  : process.argv.includes('--docs')
    ? ['../../docs/pictures/', new Map(inDocs.map((picture) => [picture, picture]))]
    : ['../../dist/pictures/', null];
const folder = new URL(place, import.meta.url);
const server = await serve();
const browser = await chromium.launch(launchOptions());
const workbench = await workbenchScript();
mkdirSync(folder, { recursive: true });
for (const [name, { reach, bench }] of Object.entries(states)) {
  if (only.length > 0 && !only.includes(name)) continue;
  for (const [size, viewport] of Object.entries(sizes)) {
    for (const theme of themes) {
      const picture = `${name}-${size}-${theme}`;
      const file = chosen ? chosen.get(picture) : picture;
      if (file === undefined) continue;
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
      // The timeline follows the field a frame later, the preview and the notes when the keys have rested for 0.4 s.
      await page.waitForTimeout(800);
      const devtools = await context.newCDPSession(page);
      const { data } = await devtools.send('Page.captureScreenshot', { format: 'webp', quality: 60 });
      writeFileSync(new URL(`${file}.webp`, folder), Buffer.from(data, 'base64'));
      await context.close();
    }
  }
  console.log(name);
}
await browser.close();
await server.close();
if (!chosen) writeFileSync(new URL('index.html', folder), album());

/** All pictures on one page. */
function album() {
  const row = (/** @type {string} */ name, /** @type {string} */ size) =>
    themes.map((theme) => `<img src="${name}-${size}-${theme}.webp" alt="${size}, ${theme}" height="480">`).join('\n');
  const parts = Object.entries(states).map(
    ([name, { title }]) =>
      `<h2>${title}</h2>\n${Object.keys(sizes)
        .map((size) => `<p>${row(name, size)}</p>`)
        .join('\n')}`,
  );
  return `<!doctype html><meta charset="utf-8"><title>The page, state by state</title>\n${parts.join('\n')}\n`;
}
