// What was measured, for people.

import { cpus, loadavg } from 'node:os';
import { version } from 'node:process';

/**
 * @typedef {object} Row as it is written to dist/bench.json
 * @property {string} name
 * @property {boolean} ours
 * @property {boolean} floor
 * @property {number} payload bytes in each frame
 * @property {number} chunk bytes in each push
 * @property {'clean' | 'damaged' | 'hostile'} stream
 * @property {number} mbPerSecond of its own stream; of the slowest hostile megabyte
 * @property {number} framesDelivered of the intact ones
 * @property {number} framesIntact
 *
 * @typedef {Row & { nsPerFrame: number, wrong: number }} Result
 *
 * @typedef {object} Siege
 * @property {string} name
 * @property {number} chunk
 * @property {string} kind
 * @property {number} ms for as much as it took
 * @property {number} taken how much of the megabyte that was, from 0 to 1
 * @property {boolean} failed it would take no more; else it was given up when it took too long
 * @property {number} next how many of the ten frames after it were delivered
 *
 * @typedef {import('./wire.js').WireResult} WireResult
 */

/**
 * @param {readonly Result[]} results
 * @param {readonly Siege[]} sieges
 * @param {readonly WireResult[]} wires
 * @param {readonly string[]} missing
 */
export function tables(results, sieges, wires, missing) {
  const clean = results.filter(({ stream }) => stream === 'clean');
  const damaged = results.filter(({ stream, floor }) => stream === 'damaged' && !floor);
  const besieged = results.filter(({ stream, floor }) => stream === 'hostile' && !floor);
  const load = loadavg().map((value) => value.toFixed(1));
  return [
    `Node ${version}, ${cpus()[0]?.model ?? 'unknown processor'}, load ${load.join(' ')}`,
    ...missing.map((peer) => `NOT MEASURED, could not be loaded: ${peer}`),
    'Columns: bytes of payload / bytes in a chunk. Each figure is the best of its rounds.',
    table('Clean, megabytes of its own stream a second', clean, ({ mbPerSecond }) => mbPerSecond.toFixed(0)),
    table('Clean, nanoseconds a frame (frames of equal payload; own framing)', clean, ({ nsPerFrame }) =>
      nsPerFrame.toFixed(0),
    ),
    ratios(clean),
    table('1 % of bytes damaged: intact frames delivered', damaged, ({ framesDelivered, framesIntact }) =>
      percent(framesDelivered / framesIntact),
    ),
    table('1 % of bytes damaged: wrong frames passed as good', damaged, ({ wrong }) => String(wrong)),
    hostile(sieges),
    table('The slowest of these megabytes: megabytes a second, frames delivered of forty', besieged, (result) =>
      [result.mbPerSecond.toFixed(result.mbPerSecond < 10 ? 1 : 0), result.framesDelivered].join(', '),
    ),
    lead(besieged),
    grid('Client, time of a job as a multiple of the time of its bytes', [
      [
        '',
        ...wires.filter(({ job }) => job === wires[0]?.job).map(({ baud, latencyMs }) => `${baud} Bd, ${latencyMs} ms`),
      ],
      ...[...new Set(wires.map(({ job }) => job))].map((job) => [
        job,
        ...wires.filter((row) => row.job === job).map(({ ratio }) => ratio.toFixed(3)),
      ]),
    ]),
  ].join('\n\n');
}

/**
 * Rounded down: what is not all is not shown as all.
 * @param {number} share
 */
function percent(share) {
  return `${(Math.floor(share * 10_000) / 100).toFixed(2)} %`;
}

/** @param {Row} row */
function slot({ payload, chunk }) {
  return `${payload}/${chunk}`;
}

/**
 * One row for each decoder, one slot for each payload and chunk.
 * @param {string} title
 * @param {readonly Result[]} results
 * @param {(result: Result) => string} cell
 */
function table(title, results, cell) {
  const names = [...new Set(results.map(({ name }) => name))];
  const slots = [...new Set(results.map(slot))];
  return grid(title, [
    ['', ...slots],
    ...names.map((name) => [name, ...results.filter((result) => result.name === name).map(cell)]),
  ]);
}

/** @param {readonly Result[]} clean */
function ratios(clean) {
  const slots = [...new Set(clean.map(slot))].map((name) => {
    const here = clean.filter((result) => slot(result) === name);
    const ours = /** @type {Result} */ (here.find((result) => result.ours));
    const floor = /** @type {Result} */ (here.find((result) => result.floor));
    const peers = here.filter((result) => !result.ours && !result.floor);
    const bytes = ours.mbPerSecond / Math.max(...peers.map(({ mbPerSecond }) => mbPerSecond));
    const frames = Math.min(...peers.map(({ nsPerFrame }) => nsPerFrame)) / ours.nsPerFrame;
    return [name, (ours.mbPerSecond / floor.mbPerSecond).toFixed(2), bytes.toFixed(2), frames.toFixed(2)];
  });
  const titles = ['', 'to the plain loop', 'to the fastest peer, in bytes', 'to the fastest peer, in frames'];
  return grid(
    'Clean, ours as a multiple',
    titles.map((title, i) => [title, ...slots.map((cells) => cells[i] ?? '')]),
  );
}

/**
 * Ours against those that deliver all frames after the hostile megabytes, and against those that do not.
 * @param {readonly Result[]} besieged
 */
function lead(besieged) {
  /** @param {(peer: Result) => boolean} counts @param {string} at */
  const over = (counts, at) => {
    const here = besieged.filter((result) => slot(result) === at);
    const ours = /** @type {Result} */ (here.find((result) => result.ours));
    const peers = here.filter((result) => !result.ours && counts(result));
    const [first] = peers.sort((a, b) => b.mbPerSecond - a.mbPerSecond);
    return first ? `${(ours.mbPerSecond / first.mbPerSecond).toFixed(1)} (${first.name})` : 'no such peer';
  };
  const slots = [...new Set(besieged.map(slot))];
  /** @param {Result} peer */
  const all = (peer) => peer.framesDelivered === peer.framesIntact;
  return grid('Hostile, ours as a multiple of the fastest peer', [
    ['', ...slots],
    ['that delivers all forty frames', ...slots.map((at) => over(all, at))],
    ['that does not', ...slots.map((at) => over((peer) => !all(peer), at))],
  ]);
}

/** @param {readonly Siege[]} sieges */
function hostile(sieges) {
  const names = [...new Set(sieges.map(({ name }) => name))];
  const kinds = [...new Set(sieges.map(({ kind }) => kind))];
  const chunks = [...new Set(sieges.map(({ chunk }) => chunk))];
  return kinds
    .map((kind) =>
      grid(
        `A megabyte of ${kind}, by size of chunk: milliseconds, and how many of the next ten frames were delivered`,
        [
          ['', ...chunks.map(String)],
          ...names.map((name) => [
            name,
            ...sieges
              .filter((siege) => siege.name === name && siege.kind === kind)
              .map(({ ms, taken, failed, next }) =>
                taken < 1 ? `${failed ? 'failed' : 'given up'} at ${percent(taken)}` : `${ms.toFixed(1)}, ${next}`,
              ),
          ]),
        ],
      ),
    )
    .join('\n\n');
}

/**
 * @param {string} title
 * @param {readonly (readonly string[])[]} lines the first are the heads, the first of each is its name
 */
export function grid(title, lines) {
  const widths = (lines[0] ?? []).map((_, i) => Math.max(...lines.map((line) => line[i]?.length ?? 0)));
  const shown = lines.map((line) =>
    line.map((cell, i) => (i === 0 ? cell.padEnd(widths[i] ?? 0) : cell.padStart(widths[i] ?? 0))).join('  '),
  );
  return [title, ...shown].join('\n');
}
