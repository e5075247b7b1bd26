// How quick the built page is: from a keystroke to its picture, and what a frame costs while a mark is dragged or while
// a timer answers. As a program (`npm run bench:screen`) it prints the tables; docs/bench.md says how to read them.
//
// All times are the browser's own, from a trace. They depend on the machine: so an empty field on an empty page is
// measured with them.

import process from 'node:process';
import { setTimeout as pause } from 'node:timers/promises';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright';
import { launchOptions } from '../tools/browser.js';
import { serve } from '../tools/serve.js';
import { grid } from './tables.js';
import { CATEGORIES, framesOf, spread, toPaint } from './trace.js';

/**
 * @typedef {object} Figures in milliseconds
 * @property {string} name
 * @property {number} slowdown of the processor
 * @property {number} count of keystrokes or frames
 * @property {number} median
 * @property {number} p95
 * @property {number} max
 *
 * @typedef {Figures & { work: number }} KeyFigures and the median of what the page itself did up to the picture
 * @typedef {Figures & { script: number, layout: number }} FrameFigures and the medians of the two parts
 * @typedef {{ keys: KeyFigures[], frames: FrameFigures[] }} ScreenResult
 *
 * @typedef {object} Series keystrokes in one field
 * @property {string} name
 * @property {string} field
 * @property {'textbox' | 'searchbox'} [role] Default: textbox
 * @property {string} [text] is typed over what stands there, again and again
 * @property {string[]} [keys] are pressed in turn
 * @property {string} [held] the key that is held meanwhile
 *
 * @typedef {object} Options
 * @property {boolean} [quick] a third of it: for a look while something is changed
 * @property {string} [folder] Default: dist/site
 */

/** A processor this many times slower than that of this machine. */
const SLOWDOWN = 4;
/** Milliseconds between two keystrokes: somebody types fast. And between two reports of the mouse. */
const KEY_PACE = 120;
const MOUSE_PACE = 16;
/** Keystrokes in a series, reports of the mouse in a drag, readings while the line is looked at. */
const KEYS = 30;
const MOVES = 150;
const READ = 6;
/** So often the timer is read before the line is looked at: more is on it then than is in sight. */
const READINGS = 12;

/** @type {readonly Series[]} */
const SERIES = [
  { name: 'digits of a time', field: 'Function 4 time', text: '12.3' },
  { name: 'digits of a position', field: 'Function 4, S2', text: '75' },
  { name: 'digits of an interval', field: 'Function 4 interval', text: '1.5' },
  { name: 'steps of a time', field: 'Function 4 time', keys: ['ArrowUp', 'ArrowDown'], held: 'Alt' },
  { name: 'steps of a position', field: 'Function 4, S2', keys: ['ArrowUp', 'ArrowDown'], held: 'Alt' },
  { name: 'from cell to cell', field: 'Function 4, S2', keys: ['ArrowDown', 'ArrowUp'] },
];
/** @type {Series} */
const SEARCH = { name: 'search in the line', field: 'Search', role: 'searchbox', text: 'servo' };
/** @type {Series} */
const EMPTY = { name: 'an empty field on an empty page', field: 'empty', text: '75' };

const DRAGS = [
  { name: 'the mark of DT', handle: 'DT time', along: { x: -80, y: 0 } },
  { name: 'a step of a servo', handle: 'Function 4, S2', along: { x: 0, y: 60 } },
];
/** The largest program that there is, made without a timer. */
const LARGEST = { functions: '20', servos: '8', name: '20 functions, 8 servos: ' };

/** Measures the built page. @returns {Promise<ScreenResult>} */
export async function screen(/** @type {Options} */ { quick = false, folder } = {}) {
  const share = quick ? 1 / 3 : 1;
  const server = await serve(folder ? { folder } : {});
  const browser = await chromium.launch(launchOptions());
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  const devtools = await page.context().newCDPSession(page);

  /** @param {number} rate */
  const slow = (rate) => devtools.send('Emulation.setCPUThrottlingRate', { rate });
  /** @param {() => Promise<void>} work @returns {Promise<import('./trace.js').TraceEvent[]>} */
  const trace = async (work) => {
    await browser.startTracing(page, { categories: CATEGORIES });
    await work();
    await pause(500);
    const { traceEvents } = JSON.parse(String(await browser.stopTracing()));
    return traceEvents;
  };

  /** @param {Series} series @returns {Promise<KeyFigures>} */
  const press = async ({ name, field, role = 'textbox', text = '', keys = [...text], held }) => {
    const input = page.getByRole(role, { name: field, exact: true }).first();
    await input.focus();
    if (held) await page.keyboard.down(held);
    await pause(500);
    const events = await trace(async () => {
      for (let stroke = 0; stroke < KEYS * share; stroke++) {
        if (text && stroke % keys.length === 0) await input.selectText();
        await page.keyboard.press(/** @type {string} */ (keys[stroke % keys.length]));
        await pause(KEY_PACE);
      }
    });
    if (held) await page.keyboard.up(held);
    await page.keyboard.press('Escape');
    const work = framesOf(events, 'keydown').map(({ script, layout }) => script + layout);
    return { name, slowdown: SLOWDOWN, ...spread(toPaint(events)), work: spread(work).median };
  };

  /** @param {typeof DRAGS[number]} drag @param {number} slowdown @returns {Promise<FrameFigures>} */
  const drag = async ({ name, handle, along }, slowdown) => {
    // Its field first: that brings the line of a servo to the front.
    await page.getByRole('textbox', { name: handle, exact: true }).focus();
    const slider = page.getByRole('slider', { name: handle, exact: true });
    await slider.scrollIntoViewIfNeeded();
    const box = /** @type {{ x: number, y: number, width: number, height: number }} */ (await slider.boundingBox());
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    const moves = MOVES * share;
    const events = await trace(async () => {
      for (let move = 1; move <= moves; move++) {
        const way = Math.sin((move / moves) * 6 * Math.PI);
        await page.mouse.move(x + way * along.x, y + way * along.y);
        await pause(MOUSE_PACE);
      }
    });
    await page.keyboard.press('Escape');
    await page.mouse.up();
    return figures(name, slowdown, framesOf(events, 'pointermove'));
  };

  /** A timer is read again and again while the line is looked at, which is full. @returns {Promise<FrameFigures>} */
  const arrive = async () => {
    const arrived = [];
    for (let reading = 0; reading < READ * share; reading++) {
      await page.goto(`${server.url}#program`);
      await page.locator('.actions').getByRole('button', { name: 'Read again' }).click();
      await page.goto(`${server.url}#line`);
      await page.locator('.line-rows li').first().waitFor();
      const events = await trace(() => page.locator('main[aria-busy=false]').waitFor());
      arrived.push(...framesOf(events, null));
    }
    return figures('a frame on the line', SLOWDOWN, arrived);
  };

  const keys = [];
  const frames = [];
  await page.setContent('<input aria-label="empty">');
  await slow(SLOWDOWN);
  keys.push(await press(EMPTY));
  await slow(1);

  await page.goto(server.url);
  await page.getByRole('button', { name: 'Try a simulated F1Q timer' }).click();
  await page.getByRole('slider').first().waitFor();
  await slow(SLOWDOWN);
  for (const series of SERIES) keys.push(await press(series));
  for (const slowdown of quick ? [SLOWDOWN] : [1, SLOWDOWN]) {
    await slow(slowdown);
    for (const each of DRAGS) frames.push(await drag(each, slowdown));
  }

  for (let reading = 0; reading < READINGS; reading++) {
    await page.locator('.actions').getByRole('button', { name: 'Read again' }).click();
    await page.locator('main[aria-busy=false]').waitFor();
  }
  frames.push(await arrive());
  keys.push(await press(SEARCH));

  await slow(1);
  await page.goto(`${server.url}#program`);
  await page.getByRole('button', { name: 'Disconnect' }).click();
  await page.getByRole('button', { name: 'Close program' }).click();
  await page.getByRole('button', { name: 'New program…' }).click();
  await page.getByRole('combobox', { name: 'Functions, without start and DT' }).selectOption(LARGEST.functions);
  await page.getByRole('combobox', { name: 'Servos' }).selectOption(LARGEST.servos);
  await page.getByRole('button', { name: 'Make the program' }).click();
  await page.getByRole('slider').first().waitFor();
  await slow(SLOWDOWN);
  for (const { name, ...each } of DRAGS) {
    frames.push(await drag({ name: LARGEST.name + name, ...each }, SLOWDOWN));
  }
  await browser.close();
  await server.close();
  return { keys, frames };
}

/**
 * @param {string} name
 * @param {number} slowdown
 * @param {import('./trace.js').FrameTimes[]} frames
 * @returns {FrameFigures}
 */
function figures(name, slowdown, frames) {
  const [script, layout] = [spread(frames.map((f) => f.script)).median, spread(frames.map((f) => f.layout)).median];
  return { name, slowdown, ...spread(frames.map((f) => f.script + f.layout)), script, layout };
}

/** The figures, for people. */
export function screenTables(/** @type {ScreenResult} */ { keys, frames }) {
  const ms = (/** @type {number} */ value) => value.toFixed(1);
  const floor = keys.find(({ name }) => name === EMPTY.name)?.median ?? Number.NaN;
  return [
    grid(`From a keystroke to its picture, milliseconds, processor slowed ${SLOWDOWN} times`, [
      ['', 'keystrokes', 'median', 'p95', 'max', 'to the empty field', 'median of own work'],
      ...keys.map(({ name, count, median, p95, max, work }) => [
        name,
        String(count),
        ...[median, p95, max].map(ms),
        (median / floor).toFixed(2),
        ms(work),
      ]),
    ]),
    grid('A frame while something is dragged or arrives, milliseconds of script and layout', [
      ['', 'slowed', 'frames', 'median', 'p95', 'max', 'median of script', 'of layout'],
      ...frames.map(({ name, slowdown, count, median, p95, max, script, layout }) => [
        name,
        `${slowdown}x`,
        String(count),
        ...[median, p95, max, script, layout].map(ms),
      ]),
    ]),
  ].join('\n\n');
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [folder, ...others] = process.argv.slice(2).filter((given) => given !== '--quick');
  if (others.length > 0) throw new Error('usage: screen.js [--quick] [folder of a built page]');
  const quick = process.argv.includes('--quick');
  console.log(screenTables(await screen({ quick, ...(folder ? { folder } : {}) })));
}
