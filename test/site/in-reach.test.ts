import { describe, expect, test } from 'vitest';
import { LANGUAGES } from '../../src/app/messages/first.js';
import { OVER, outOfReach } from '../tools/in-reach.js';
import { states } from '../tools/picture-states.js';
import { AppPage } from './app-page.js';
import { showTheme } from './themes.js';

type Size = readonly [width: number, height: number];
/** For touch: two phones, one of them on its side, and a tablet. */
const BY_TOUCH: readonly [Size, ...Size[]] = [
  [360, 740],
  [390, 844],
  [844, 390],
  [820, 1180],
];
/** With a mouse: three laptops, and the first of them at 200 and 400 per cent. */
const BY_MOUSE: readonly [Size, ...Size[]] = [
  [1280, 800],
  [1366, 650],
  [1440, 900],
  [640, 400],
  [320, 256],
];

/** What a pilot meets most, by the names of the states that have pictures. */
const LOOKED_AT = [
  'start',
  'new-program',
  'refused',
  'disturbed',
  'errors',
  'shift',
  'figures',
  'apart',
  'commands',
  'write',
  'verified',
  'memories',
  'copy',
  'pair',
  'preview',
  'bench',
  'following',
  'tried',
  'empty-library',
  'setting',
  'line',
  'known',
  'settings',
  'settle',
  'erase',
  'away',
];

const faultsOf = (app: AppPage): Promise<readonly string[]> => app.page.evaluate(outOfReach, OVER);

/** What is still out of reach when the page has come to rest: it scrolls back to the field after its words changed. */
async function lasting(app: AppPage): Promise<readonly string[]> {
  const found = await faultsOf(app);
  if (found.length === 0) return found;
  await app.page.waitForTimeout(500);
  return faultsOf(app);
}

/** @param least where words have the least room: looked at in each language. */
async function look(app: AppPage, sizes: readonly Size[], least: Size): Promise<readonly string[]> {
  const all: string[] = [];
  const see = async (look: string, found: Promise<readonly string[]>): Promise<void> => {
    for (const fault of await found) all.push(`${look}: ${fault}`);
  };
  const resize = ([width, height]: Size): Promise<void> => app.resize({ width, height });
  for (const size of sizes) {
    await resize(size);
    await see(size.join('x'), faultsOf(app));
  }
  await resize(least);
  for (const language of LANGUAGES) {
    await app.speak(language);
    await see(`${least.join('x')}, ${language}`, lasting(app));
  }
  await app.speak('en');
  await app.page.evaluate(spreadText);
  // Where room is scarce: the strip on a phone, the rail on a tablet and a laptop.
  for (const size of sizes.filter((each) => each === sizes[0] || each[0] === 820)) {
    await resize(size);
    await see(`${size.join('x')} with spread text`, faultsOf(app));
  }
  return all;
}

/** Text with as much space as a reader may ask for: WCAG 1.4.12. Runs in the page. */
function spreadText(): void {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync(`
    * { line-height: 1.5 !important; letter-spacing: 0.12em !important; word-spacing: 0.16em !important; }
    p { margin-block-end: 2em !important; }
  `);
  document.adoptedStyleSheets = [sheet];
}

describe.each([
  ['a finger', BY_TOUCH, [320, 640], { hasTouch: true, isMobile: true }],
  ['a mouse', BY_MOUSE, [1280, 800], {}],
] as const)(
  'all that is there can be read and pressed with %s, in each size and language',
  (_, sizes, least, device) => {
    test.each(LOOKED_AT)('in the state %s', async (name) => {
      const { bench, reach } = states[name] as (typeof states)[string];
      const [[width, height]] = sizes;
      const app = await AppPage.open({ ...device, ...(bench && { bench }), viewport: { width, height } });
      // The largest letters.
      await showTheme(app, 'sun');
      await reach(app.page);
      expect(await look(app, sizes, least)).toEqual([]);
    });
  },
);
