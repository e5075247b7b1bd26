// How quick the built page is: from a keystroke to its picture, and what a frame costs while a mark is dragged. As a
// program (`npm run bench:screen`) it prints the tables; docs/bench.md says how to read them.
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
 * @property {string} [text] is typed over what stands there, again and again
 * @property {string[]} [keys] are pressed in turn
 * @property {string} [held] the key that is held meanwhile
 *
 * @typedef {{ name: string, ph: string, ts: number, dur?: number, tdur?: number, pid: number, tid: number, args: any }}
 * TraceEvent
 */

/** A processor this many times slower than that of this machine. */
const SLOWDOWN = 4;
/** Milliseconds between two keystrokes: somebody types fast. And between two reports of the mouse. */
const KEY_PACE = 120;
const MOUSE_PACE = 16;
/** Keystrokes in a series, and reports of the mouse in a drag. */
const KEYS = 30;
const MOVES = 150;

/** @type {readonly Series[]} */
const SERIES = [
  { name: 'digits of a time', field: 'Function 4 time', text: '12.3' },
  { name: 'digits of a position', field: 'Function 4, S2', text: '75' },
  { name: 'digits of an interval', field: 'Function 4 interval', text: '1.5' },
  { name: 'digits of the large DT', field: 'DT', text: '245' },
  { name: 'steps of a time', field: 'Function 4 time', keys: ['ArrowUp', 'ArrowDown'], held: 'Alt' },
  { name: 'steps of a position', field: 'Function 4, S2', keys: ['ArrowUp', 'ArrowDown'], held: 'Alt' },
  { name: 'from cell to cell', field: 'Function 4, S2', keys: ['ArrowDown', 'ArrowUp'] },
];
const EMPTY = 'an empty field on an empty page';

const DRAGS = [
  { name: 'the mark of DT', handle: 'DT time', along: { x: -80, y: 0 } },
  { name: 'a step of a servo', handle: 'Function 4, S2', along: { x: 0, y: 60 } },
];

const SCRIPT = [
  'EvaluateScript',
  'FunctionCall',
  'EventDispatch',
  'RunMicrotasks',
  'TimerFire',
  'FireAnimationFrame',
  'FireIdleCallback',
  'MinorGC',
  'MajorGC',
];
const LAYOUT = ['UpdateLayoutTree', 'Layout', 'HitTest', 'PrePaint', 'Paint', 'Layerize'];

/** Measures dist/site. @returns {Promise<ScreenResult>} */
export async function screen() {
  const server = await serve();
  const browser = await chromium.launch(launchOptions());
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  const devtools = await page.context().newCDPSession(page);

  /** @param {number} rate */
  const slow = (rate) => devtools.send('Emulation.setCPUThrottlingRate', { rate });
  /** @param {() => Promise<void>} work @returns {Promise<TraceEvent[]>} */
  const trace = async (work) => {
    await browser.startTracing(page, { categories: ['devtools.timeline', 'v8.execute'] });
    await work();
    await pause(500);
    const { traceEvents } = JSON.parse(String(await browser.stopTracing()));
    return traceEvents;
  };

  /** @param {Series} series @returns {Promise<KeyFigures>} */
  const press = async ({ name, field, text = '', keys = [...text], held }) => {
    const input = page.getByRole('textbox', { name: field, exact: true }).first();
    await input.focus();
    if (held) await page.keyboard.down(held);
    await pause(500);
    const events = await trace(async () => {
      for (let stroke = 0; stroke < KEYS; stroke++) {
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
    const events = await trace(async () => {
      for (let move = 1; move <= MOVES; move++) {
        const way = Math.sin((move / MOVES) * 6 * Math.PI);
        await page.mouse.move(x + way * along.x, y + way * along.y);
        await pause(MOUSE_PACE);
      }
    });
    await page.keyboard.press('Escape');
    await page.mouse.up();
    const frames = framesOf(events, 'pointermove');
    const [script, layout] = [spread(frames.map((f) => f.script)).median, spread(frames.map((f) => f.layout)).median];
    return { name, slowdown, ...spread(frames.map((f) => f.script + f.layout)), script, layout };
  };

  const keys = [];
  const frames = [];
  await page.setContent('<input aria-label="empty">');
  await slow(SLOWDOWN);
  keys.push(await press({ name: EMPTY, field: 'empty', text: '75' }));
  await slow(1);
  await page.goto(server.url);
  await page.getByRole('button', { name: 'Try a simulated F1Q timer' }).click();
  await page.getByRole('slider').first().waitFor();
  await slow(SLOWDOWN);
  for (const series of SERIES) keys.push(await press(series));
  for (const slowdown of [1, SLOWDOWN]) {
    await slow(slowdown);
    for (const each of DRAGS) frames.push(await drag(each, slowdown));
  }
  await browser.close();
  await server.close();
  return { keys, frames };
}

/**
 * From each keystroke to the picture of what it did. Event Timing, but not rounded to 8 ms as a page would be told it.
 */
function toPaint(/** @type {TraceEvent[]} */ events) {
  /** @type {Map<number, number>} */
  const strokes = new Map();
  for (const { name, ph, args } of events) {
    if (name !== 'EventTiming' || ph !== 'b' || !['keydown', 'keypress'].includes(args.data.type)) continue;
    const { interactionId, duration } = args.data;
    strokes.set(interactionId, Math.max(duration, strokes.get(interactionId) ?? 0));
  }
  return [...strokes.values()];
}

/**
 * What the page did for each frame that an event of a type came before; the others only carry on what these have begun.
 * A layout that a script has forced is counted as layout.
 * @param {TraceEvent[]} events
 * @param {'pointermove' | 'keydown'} type
 */
function framesOf(events, type) {
  const { pid, tid } = events.find(({ name }) => name === 'Layerize') ?? {};
  const own = events
    .filter((event) => event.ph === 'X' && event.pid === pid && event.tid === tid)
    .sort((a, b) => a.ts - b.ts || (b.dur ?? 0) - (a.dur ?? 0));
  const frames = [];
  let frame = { script: 0, layout: 0, isMeant: false };
  let [scripted, laidOut] = [0, 0];
  // Time of the thread: what other programs take meanwhile is not counted.
  for (const { name, ts, dur = 0, tdur = dur, args } of own) {
    const end = ts + dur;
    frame.isMeant ||= name === 'EventDispatch' && args.data.type === type;
    if (LAYOUT.includes(name)) {
      if (ts < laidOut) continue;
      frame.layout += tdur / 1000;
      if (ts < scripted) frame.script -= tdur / 1000;
      laidOut = end;
    } else if (SCRIPT.includes(name) && ts >= scripted) {
      frame.script += tdur / 1000;
      scripted = end;
    }
    if (name !== 'Layerize') continue;
    if (frame.isMeant) frames.push(frame);
    frame = { script: 0, layout: 0, isMeant: false };
  }
  return frames;
}

function spread(/** @type {number[]} */ values) {
  const sorted = values.toSorted((a, b) => a - b);
  const at = (/** @type {number} */ share) => sorted[Math.ceil(share * sorted.length) - 1] ?? Number.NaN;
  return { count: sorted.length, median: at(0.5), p95: at(0.95), max: at(1) };
}

/** The figures, for people. */
export function screenTables(/** @type {ScreenResult} */ { keys, frames }) {
  const ms = (/** @type {number} */ value) => value.toFixed(1);
  const floor = keys.find(({ name }) => name === EMPTY)?.median ?? Number.NaN;
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
    grid('Dragging, milliseconds of script and layout in a frame', [
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

if (process.argv[1] === fileURLToPath(import.meta.url)) console.log(screenTables(await screen()));
