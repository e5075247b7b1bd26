import { execSync } from 'node:child_process';
import { mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { env } from 'node:process';
import { afterAll, beforeAll, expect, inject, test } from 'vitest';
import { leftOut } from '../tools/left-out.js';
import { states } from '../tools/picture-states.js';
import { serve } from '../tools/serve.js';
import { newPage } from './page.js';

/** What never comes from en.ftl, by its forms. */
const KNOWN = [
  'Sidus Timer',
  // What a pilot has typed, also into a file or a table.
  'Lancer\\s07|(?:calm|windy)\\smorning|calm|contest|Good air over the wood|Fly-\u2060?off|“Zeit”|“up”',
  'field\\.(?:sidus\\.json|txt)|Sidus library [\\d\u2060-]+\\.sidus\\.json',
  // Days, which are German by then.
  '(?:Mo|Di|Mi|Do|Fr|Sa|So)\\.,\\s\\d+\\.\\s\\p{L}+\\.?\\s\\d{4}',
  // Words of the line, of a file, of Linux and of printers.
  '(?:[0-9a-f]{2} )+[0-9a-f]{2}|(?:GET|SET)[A-Z]+|UNLOCK',
  '(?<=, )time(?=: )',
  'sudo usermod -a -G dialout \\$USER',
  'Letter',
];

const folder = mkdtempSync(join(tmpdir(), 'sidus-timer-pseudo-'));
let served: Awaited<ReturnType<typeof serve>>;

beforeAll(async () => {
  execSync(`npm run --silent build:site -- --mode pseudo --outDir "${folder}" --emptyOutDir`, {
    env: { ...env, NODE_ENV: 'production' },
    stdio: ['ignore', 'ignore', 'inherit'],
  });
  served = await serve({ folder });
});
afterAll(async () => {
  await served.close();
  rmSync(folder, { recursive: true, force: true });
});

// Each state is reached in English, in which it may have kept a text; then the page changes its language.
test.for(Object.entries(states))('no text is left in English: %s', async ([, { bench, reach }]) => {
  const page = await newPage({ reducedMotion: 'reduce' });
  if (bench) {
    await page.addInitScript((given) => {
      window.workbenchOptions = given;
    }, bench);
    await page.addInitScript(inject('workbench'));
  }
  await page.goto(served.url);
  await reach(page);
  await page.evaluate(() => {
    localStorage.setItem('sidus-timer/language', '"de"');
    window.dispatchEvent(new Event('languagechange'));
  });
  await page.locator('html[lang=de]').waitFor();
  const look = `(${leftOut.toString()})(document.documentElement, ${JSON.stringify(KNOWN)})`;
  await expect.poll(() => page.evaluate(look)).toEqual([]);
  expect(await page.locator('body').innerText()).toContain('⟦');
});
