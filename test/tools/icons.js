// Draws the icons of public/ from favicon.svg. Run it again when that file has changed: node test/tools/icons.js

import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright';
import { launchOptions } from './browser.js';

const folder = new URL('../../public/', import.meta.url);
const rounded = readFileSync(new URL('favicon.svg', folder), 'utf8');
// For systems that cut the shape themselves, the background fills the corners.
const full = rounded.replace('rx="112"', '');

const icons = [
  { file: 'icon-192.png', size: 192, svg: rounded },
  { file: 'icon-512.png', size: 512, svg: rounded },
  { file: 'icon-maskable-512.png', size: 512, svg: full },
  { file: 'apple-touch-icon.png', size: 180, svg: full },
];

const browser = await chromium.launch(launchOptions());
for (const { file, size, svg } of icons) {
  const page = await browser.newPage({ viewport: { width: size, height: size } });
  await page.setContent(`<style>body { margin: 0 } svg { display: block }</style>${svg}`);
  await page.screenshot({ path: fileURLToPath(new URL(file, folder)), omitBackground: true });
}
await browser.close();
