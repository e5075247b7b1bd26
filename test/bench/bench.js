// Our decoder against others on npm and against a plain loop, and the client against the wire. `npm run bench` prints
// the tables and writes dist/bench.json; docs/bench.md says how to read them.
//
// All decoders take turns, round by round, and each counts by its best round: on a machine that does other things at
// the same time only what was measured in one run can be compared, and the best round is the least disturbed one. A
// tool that measures one after another, as tinybench does, compares different moments.

import { execSync } from 'node:child_process';
import { existsSync, mkdirSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { contestants, Sink } from './contestants.js';
import { chunksOf, cleanStream, damagedStream, HOSTILE, payloads } from './streams.js';
import { tables } from './tables.js';
import { wire } from './wire.js';

/**
 * @typedef {import('./contestants.js').Contestant} Contestant
 * @typedef {import('./streams.js').Stream} Stream
 *
 * @typedef {import('./tables.js').Row} Row
 * @typedef {import('./tables.js').Result} Result
 */

const PAYLOADS = [0, 22, 33];
const CHUNKS = [1, 16, 4096];
/** Frames in a stream, by the size of the chunks: about a millisecond for a quick decoder. */
const FRAMES = new Map([
  [1, 1000],
  [16, 3000],
  [4096, 10_000],
]);
/** Milliseconds that each decoder gets for each stream, and how many rounds at least and at most. */
const BUDGET = 200;
const ROUNDS = [7, 300];
/**
 * Milliseconds after which a hostile megabyte is given up: what some decoders hold back grows, and with it the time for
 * each byte.
 */
const LONGEST = 1000;

install();
const { contestants: decoders, missing } = await contestants();
const results = /** @type {Result[]} */ ([]);
for (const payload of PAYLOADS) {
  for (const chunk of CHUNKS) {
    results.push(...(await compare('clean', payload, chunk)), ...(await compare('damaged', payload, chunk)));
  }
}
const sieges = /** @type {import('./tables.js').Siege[]} */ ([]);
for (const chunk of CHUNKS) for (const decoder of decoders) results.push(await besiege(decoder, chunk));
const wires = [];
for (const baud of [9600, 115_200]) for (const latencyMs of [0, 30]) wires.push(...(await wire(baud, latencyMs)));

console.log(tables(results, sieges, wires, missing));
const file = new URL('../../dist/bench.json', import.meta.url);
mkdirSync(new URL('.', file), { recursive: true });
const rows = results.map(({ nsPerFrame, wrong, ...row }) => row);
writeFileSync(file, `${JSON.stringify({ decoders: rows, wire: wires }, null, 2)}\n`);

function install() {
  const here = fileURLToPath(new URL('.', import.meta.url));
  if (!existsSync(`${here}node_modules/.package-lock.json`))
    execSync('npm ci --no-audit --no-fund', { cwd: here, stdio: 'inherit' });
}

/**
 * Feeds the same payloads to all decoders.
 * @param {'clean' | 'damaged'} stream
 * @param {number} payload
 * @param {number} chunk
 * @returns {Promise<Result[]>}
 */
async function compare(stream, payload, chunk) {
  const sent = payloads(/** @type {number} */ (FRAMES.get(chunk)), payload);
  const entries = decoders.map((decoder) => {
    const frames = sent.map((data) => decoder.encode(data));
    const { bytes, intact } = stream === 'clean' ? cleanStream(frames) : damagedStream(frames, decoder.spare);
    return { decoder, intact, bytes, chunks: chunksOf(bytes, chunk, decoder.chunk), best: Infinity, spent: 0 };
  });
  const [least = 0, most = 0] = ROUNDS;
  for (let round = 0; round < most; round++) {
    for (let turn = 0; turn < entries.length; turn++) {
      // No decoder always comes after the same one.
      const entry = /** @type {typeof entries[number]} */ (entries[(turn + round) % entries.length]);
      if (round >= least && entry.spent > BUDGET) continue;
      const { ms } = await run(entry.decoder, entry.chunks, new Sink());
      entry.best = Math.min(entry.best, ms);
      entry.spent += ms;
    }
  }
  const rows = [];
  for (const { decoder, intact, bytes, chunks, best } of entries) {
    const sink = new Sink();
    sink.kept = [];
    const { taken } = await run(decoder, chunks, sink);
    const { right, wrong } = judge(sink.kept, sent, intact);
    const framesIntact = intact.filter(Boolean).length;
    if (stream === 'clean' && !decoder.floor && (right < framesIntact || wrong > 0)) {
      throw new Error(
        `${decoder.name} must deliver all ${framesIntact} whole frames and no other, but delivers ${right}, and ${wrong} wrong ones`,
      );
    }
    rows.push({
      ...row(decoder, stream, payload, chunk, (bytes.length * taken) / best / 1000),
      framesDelivered: right,
      framesIntact,
      nsPerFrame: (best * 1e6) / sent.length,
      wrong,
    });
  }
  return rows;
}

/**
 * One new decoder takes one stream.
 * @param {Contestant} decoder
 * @param {readonly Uint8Array[]} chunks
 * @param {Sink} sink
 * @param {number} [batch] chunks after which the clock is looked at
 * @param {number} [longest] milliseconds after which it is given up
 * @returns {Promise<{ ms: number, taken: number, failed: boolean }>} taken: how much of it, from 0 to 1, before it
 * failed or was given up
 */
async function run(decoder, chunks, sink, batch = chunks.length, longest = Infinity) {
  const feed = decoder.start(sink);
  await new Promise(setImmediate);
  const begin = performance.now();
  let at = 0;
  let failed = false;
  while (!failed && at < chunks.length && performance.now() - begin < longest) {
    const to = Math.min(chunks.length, at + batch);
    at += feed.push(chunks, at, to);
    failed = at < to;
  }
  const ms = performance.now() - begin;
  feed.end?.();
  return { ms, taken: at / chunks.length, failed };
}

/**
 * How many of the delivered are intact frames, and how many were never sent. What was damaged and delivered as it was
 * sent all the same is neither.
 * @param {readonly Uint8Array[]} delivered
 * @param {readonly Uint8Array[]} sent
 * @param {readonly boolean[]} intact
 */
function judge(delivered, sent, intact) {
  /** @type {Map<string, { sent: number, intact: number }>} */
  const expected = new Map();
  for (const [index, data] of sent.entries()) {
    const counts = expected.get(String(data)) ?? { sent: 0, intact: 0 };
    counts.sent++;
    if (intact[index]) counts.intact++;
    expected.set(String(data), counts);
  }
  let right = 0;
  let wrong = 0;
  for (const data of delivered) {
    const counts = expected.get(String(data));
    if (!counts || counts.sent-- <= 0) wrong++;
    else if (counts.intact-- > 0) right++;
  }
  return { right, wrong };
}

/**
 * Each hostile megabyte by itself, with ten good frames after it. The slowest one counts.
 * @param {Contestant} decoder
 * @param {number} chunk
 * @returns {Promise<Result>}
 */
async function besiege(decoder, chunk) {
  const sent = payloads(10, 33);
  let slowest = Infinity;
  let right = 0;
  let wrong = 0;
  for (const [kind, megabyte] of Object.entries(HOSTILE)) {
    const bytes = Buffer.concat([megabyte, ...sent.map((data) => decoder.encode(data))]);
    const chunks = chunksOf(bytes, chunk, decoder.chunk);
    let best = { ms: Infinity, taken: 0, failed: false };
    for (let round = 0; round < 7; round++) {
      const siege = await run(decoder, chunks, new Sink(), Math.ceil(4096 / chunk), LONGEST);
      if (siege.taken > best.taken || (siege.taken === best.taken && siege.ms < best.ms)) best = siege;
      if (siege.ms > LONGEST / 2) break;
    }
    const sink = new Sink();
    sink.kept = [];
    if (best.taken === 1) await run(decoder, chunks, sink);
    const judged = judge(
      sink.kept,
      sent,
      sent.map(() => true),
    );
    sieges.push({
      name: decoder.name,
      chunk,
      kind,
      ms: best.ms,
      taken: best.taken,
      failed: best.failed,
      next: judged.right,
    });
    slowest = Math.min(slowest, (bytes.length * best.taken) / best.ms / 1000);
    right += judged.right;
    wrong += judged.wrong;
  }
  const framesIntact = sent.length * Object.keys(HOSTILE).length;
  return { ...row(decoder, 'hostile', 33, chunk, slowest), framesDelivered: right, framesIntact, nsPerFrame: 0, wrong };
}

/**
 * @param {Contestant} decoder
 * @param {Row['stream']} stream
 * @param {number} payload
 * @param {number} chunk
 * @param {number} mbPerSecond
 */
function row({ name, ours, floor }, stream, payload, chunk, mbPerSecond) {
  return { name, ours, floor, payload, chunk, stream, mbPerSecond: Number(mbPerSecond.toPrecision(4)) };
}
