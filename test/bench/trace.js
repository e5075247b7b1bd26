// What a trace of the browser tells of keystrokes and frames.

/**
 * @typedef {{ name: string, ph: string, ts: number, dur?: number, tdur?: number, pid: number, tid: number, args: any }}
 * TraceEvent
 *
 * @typedef {object} FrameTimes of the thread, in milliseconds: what other programs take meanwhile is not counted
 * @property {number} script
 * @property {number} layout styles, layout and painting
 */

/** What the browser has to note for the functions below. */
export const CATEGORIES = ['devtools.timeline', 'v8.execute'];

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

/**
 * From each keystroke to the picture of what it did, in milliseconds. Event Timing, but not rounded to 8 ms as a page
 * would be told it.
 */
export function toPaint(/** @type {TraceEvent[]} */ events) {
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
 * @param {'pointermove' | 'keydown' | null} type null: each frame for which anything was laid out
 * @returns {FrameTimes[]}
 */
export function framesOf(events, type) {
  const { pid, tid } = events.find(({ name }) => name === 'Layerize') ?? {};
  const own = events
    .filter((event) => event.ph === 'X' && event.pid === pid && event.tid === tid)
    .sort((a, b) => a.ts - b.ts || (b.dur ?? 0) - (a.dur ?? 0));
  const frames = [];
  let frame = { script: 0, layout: 0, isMeant: false };
  let [scripted, laidOut] = [0, 0];
  for (const { name, ts, dur = 0, tdur = dur, args } of own) {
    const end = ts + dur;
    frame.isMeant ||= type === null ? name === 'Layout' : name === 'EventDispatch' && args.data.type === type;
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

export function spread(/** @type {number[]} */ values) {
  const sorted = values.toSorted((a, b) => a - b);
  const at = (/** @type {number} */ share) => sorted[Math.ceil(share * sorted.length) - 1] ?? Number.NaN;
  return { count: sorted.length, median: at(0.5), p95: at(0.95), max: at(1) };
}
