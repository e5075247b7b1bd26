// Takes pictures of the built page: each state of picture-states.js in each theme.
//   npm run pictures              on a desktop and a phone, into dist/pictures with an index.html to look at
//   npm run pictures -- --sizes   in all seven sizes
//   npm run pictures -- --docs    the few that README and docs show, into docs/pictures
//   npm run pictures -- --manifest    those for browsers that install the page, into public/screenshots
//   npm run pictures -- --language de,hu    in these languages, in the light theme, on a phone and a laptop
// Names of states as further arguments take only these. What is wrong is named at the end, and the program fails: a
// state that cannot be reached, what axe finds, what a finger would miss, what is wider than the window; in a language
// also what is cut off or covered, there and on the smallest phone. Needs a built page: npm run build:site

import { mkdirSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import process from 'node:process';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright';
import { launchOptions } from './browser.js';
import { OVER, outOfReach } from './in-reach.js';
import { inDocs, inManifest, states } from './picture-states.js';
import { serve } from './serve.js';
import { faultsOf } from './well-made.js';
import { workbenchScript } from './workbench-script.js';

/** @typedef {Readonly<Record<string, { width: number, height: number, touch?: boolean }>>} Sizes */
const phone = { width: 390, height: 844, touch: true };
/** @type {Sizes} */
const sizes = { desktop: { width: 1280, height: 800 }, phone };
const laptop = { width: 1366, height: 650 };
/** @type {Sizes} */
const furtherSizes = {
  'small-phone': { width: 360, height: 740, touch: true },
  'side-phone': { width: 844, height: 390, touch: true },
  tablet: { width: 820, height: 1180, touch: true },
  laptop,
  wide: { width: 1440, height: 900 },
};
const smallest = { width: 320, height: 640 };

const { values: asked, positionals: only } = parseArgs({
  allowPositionals: true,
  options: {
    sizes: { type: 'boolean' },
    docs: { type: 'boolean' },
    manifest: { type: 'boolean' },
    language: { type: 'string' },
  },
});
const languages = asked.language?.split(',');
/** What a state is shown in, one after another. */
const looks = languages ?? ['light', 'dark', 'sun'];
/** @type {Sizes} */
const taken = languages ? { phone, laptop } : asked.sizes ? { ...sizes, ...furtherSizes } : sizes;
/** The folder and the list of pictures, by their names there. */
const [place, chosen] = asked.manifest
  ? ['../../public/screenshots/', new Map(Object.entries(inManifest).map(([name, picture]) => [picture, name]))]
  : asked.docs
    ? ['../../docs/pictures/', new Map(inDocs.map((picture) => [picture, picture]))]
    : ['../../dist/pictures/', null];
const folder = new URL(place, import.meta.url);
const server = await serve();
const browser = await chromium.launch(launchOptions());
const workbench = await workbenchScript();
mkdirSync(folder, { recursive: true });

const jobs = Object.keys(states)
  .filter((name) => only.length === 0 || only.includes(name))
  .flatMap((name) => Object.keys(taken).map((size) => ({ name, size })));
/** @type {string[]} */
const failed = [];
// A state that waits for its timer leaves the processor to another.
await Promise.all(Array.from({ length: availableParallelism() + 1 }, work));
await browser.close();
await server.close();
if (!chosen) writeFileSync(new URL('index.html', folder), album());
if (failed.length > 0) console.error(`Not as it should be:\n${failed.join('\n')}`);
process.exitCode = failed.length > 0 ? 1 : 0;

async function work() {
  for (let job = jobs.shift(); job; job = jobs.shift()) {
    const { name, size } = job;
    await take(name, size).catch((error) => failed.push(`${name}, ${size}: ${error.message}`));
  }
}

/** Takes a state in each look. @param {string} name @param {string} size */
async function take(name, size) {
  const wanted = looks.filter((look) => !chosen || chosen.has(`${name}-${size}-${look}`));
  const { [name]: state } = states;
  const { [size]: screen } = taken;
  if (wanted.length === 0 || !state || !screen) return;
  const { touch: hasTouch = false, ...viewport } = screen;
  const context = await browser.newContext({ viewport, hasTouch, reducedMotion: 'reduce' });
  try {
    const page = await context.newPage();
    if (state.bench) {
      await page.addInitScript((given) => {
        window.workbenchOptions = given;
      }, state.bench);
      await page.addInitScript(workbench);
    }
    await page.goto(server.url);
    await state.reach(page);
    const devtools = await context.newCDPSession(page);
    for (const [index, look] of wanted.entries()) {
      await (languages ? speak : showTheme)(page, look);
      // The timeline follows the field a frame later, the preview and the notes when the keys have rested for 0.4 s.
      await page.waitForTimeout(800);
      const { data } = await devtools.send('Page.captureScreenshot', { format: 'webp', quality: 60 });
      const picture = `${name}-${size}-${look}`;
      writeFileSync(new URL(`${chosen?.get(picture) ?? picture}.webp`, folder), Buffer.from(data, 'base64'));
      const faults = await faultsOf(page, !languages && index > 0);
      if (languages) faults.push(...(await page.evaluate(outOfReach, OVER)));
      if (languages && hasTouch) faults.push(...(await onSmallest(page)));
      for (const fault of faults) failed.push(`${picture}: ${fault}`);
    }
    console.log(`${name}, ${size}`);
  } finally {
    await context.close();
  }
}

/** The styles look at nothing else. @param {import('playwright').Page} page @param {string} theme */
function showTheme(page, theme) {
  return page.evaluate((shown) => document.documentElement.setAttribute('data-theme', shown), theme);
}

/**
 * As if it were chosen in the settings: all that is on the screen stays.
 * @param {import('playwright').Page} page
 * @param {string} language
 */
async function speak(page, language) {
  await page.evaluate((code) => {
    localStorage.setItem('sidus-timer/language', JSON.stringify(code));
    dispatchEvent(new Event('languagechange'));
  }, language);
  await page.locator(`html[lang=${language}]`).waitFor();
}

/** What is cut off or covered on the smallest phone. @param {import('playwright').Page} page */
async function onSmallest(page) {
  await page.setViewportSize(smallest);
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  const faults = await page.evaluate(outOfReach, OVER);
  await page.setViewportSize(phone);
  return faults.map((fault) => `${smallest.width} px: ${fault}`);
}

/** All pictures on one page. */
function album() {
  const row = (/** @type {string} */ name, /** @type {string} */ size) =>
    looks.map((look) => `<img src="${name}-${size}-${look}.webp" alt="${size}, ${look}" height="480">`).join('\n');
  const parts = Object.entries(states).map(
    ([name, { title }]) =>
      `<h2>${title}</h2>\n${Object.keys(taken)
        .map((size) => `<p>${row(name, size)}</p>`)
        .join('\n')}`,
  );
  return `<!doctype html><meta charset="utf-8"><title>The page, state by state</title>\n${parts.join('\n')}\n`;
}
