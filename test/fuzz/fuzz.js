// Tries the laws on stream after stream for as long as it is told to, and watches the memory. `npm run fuzz --
// --minutes 10 --seed 123`. A failure is shown as small as it can be made, with the line that brings it back.

import { argv, exit, memoryUsage, stderr, stdout } from 'node:process';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import fc from 'fast-check';
import { PageDecoder } from '../protocol/reference.js';
import { KEPT_LAWS } from './kept-laws.js';
import { LAWS } from './laws.js';
import { hex, stream } from './streams.js';

/**
 * @typedef {import('./laws.js').Protocol} Protocol
 * @typedef {{ law: string, seed: number, report: string }} Failure
 */

/**
 * Bytes by which the heap may grow from the first measurements to the last: what comes and goes, and nothing that
 * stays.
 */
const GROWTH = 4 * 1024 * 1024;
/** Milliseconds for one law in one round: a failure is made no smaller after that. */
const LONGEST_ROUND = 30_000;
/** Rounds before the heap counts: until then code is still being compiled. */
const WARM_UP = 3;

/**
 * Runs rounds of all laws until it is told to stop or one of them fails. Round n of seed s is round 0 of seed s + n.
 * @template {Protocol} P
 * @param {P} protocol
 * @param {{ seed: number, cases: number, more: (round: number, cases: number) => boolean,
 *   laws?: Record<string, (protocol: P) => fc.IProperty<any>> }} options cases: of each law in each round
 * @returns {{ cases: number, failure: Failure | null }}
 */
export function fuzz(protocol, { seed, cases, more, laws = LAWS }) {
  const marathon = longLived(protocol);
  const heap = [];
  let done = 0;
  for (let round = 0; more(round, done); round++) {
    const roundSeed = (seed + round) | 0;
    for (const [law, property] of Object.entries(laws)) {
      const result = fc.check(property(protocol), {
        seed: roundSeed,
        numRuns: cases,
        interruptAfterTimeLimit: LONGEST_ROUND,
      });
      done += result.numRuns;
      if (result.failed)
        return { cases: done, failure: { law, seed: roundSeed, report: fc.defaultReportMessage(result) ?? '' } };
    }
    const wrong = marathon(roundSeed, cases);
    if (wrong) return { cases: done, failure: { law: 'one decoder for all streams', seed: roundSeed, report: wrong } };
    if (!globalThis.gc || round < WARM_UP) continue;
    globalThis.gc();
    heap.push(memoryUsage().heapUsed);
    const growth = Math.min(...heap.slice(-3)) - Math.max(...heap.slice(0, 3));
    if (growth > GROWTH) {
      return { cases: done, failure: { law: 'flat memory', seed, report: `The heap has grown by ${growth} bytes.` } };
    }
  }
  return { cases: done, failure: null };
}

/** One decoder that is never made anew, against the program of the protocol page. @param {Protocol} protocol */
function longLived({ FrameDecoder }) {
  const decoder = new FrameDecoder();
  const page = new PageDecoder();
  return (/** @type {number} */ seed, /** @type {number} */ cases) => {
    for (const { bytes } of fc.sample(stream, { seed, numRuns: Math.ceil(cases / 10) })) {
      const silent = bytes.length % 3 === 0;
      const found = [...decoder.push(bytes), ...(silent ? decoder.idle() : [])];
      const expected = [...page.push(bytes), ...(silent ? page.idle() : [])];
      const [is, should] = [found, expected].map((frames) =>
        frames.map(({ code, data }) => hex([code, ...data])).join(' / '),
      );
      if (is !== should) return `After ${hex(bytes)}\n  delivered ${is}\n  should be ${should}`;
    }
    return undefined;
  };
}

async function main() {
  const { values } = parseArgs({
    options: { minutes: { type: 'string' }, seed: { type: 'string' }, cases: { type: 'string' } },
  });
  const minutes = Number(values.minutes ?? 1);
  const seed = Number(values.seed ?? Date.now() % 1e9);
  const cases = Number(values.cases ?? 1000);
  if (!(minutes > 0) || !Number.isInteger(seed) || !(cases > 0)) {
    stderr.write('npm run fuzz -- [--minutes 1] [--seed WHOLE NUMBER] [--cases 1000]\n');
    return 2;
  }
  // The built package, as those get it who install it.
  const protocol = await import('../../dist/lib/protocol/index.js');
  const program = await import('../../dist/lib/program/index.js');
  const begin = performance.now();
  const seconds = () => (performance.now() - begin) / 1000;
  let told = 0;
  stdout.write(
    `Seed ${seed}, ${minutes} min${globalThis.gc ? '' : '; the memory is not watched (that needs node --expose-gc)'}\n`,
  );
  const { cases: done, failure } = fuzz(
    { ...protocol, ...program },
    {
      laws: { ...LAWS, ...KEPT_LAWS },
      seed,
      cases,
      more: (round, count) => {
        if (seconds() > told + 30) {
          told = seconds();
          stdout.write(
            `${told.toFixed(0)} s: round ${round}, ${count} cases, heap ${(memoryUsage().heapUsed / 1e6).toFixed(1)} MB\n`,
          );
        }
        return seconds() < 60 * minutes;
      },
    },
  );
  if (!failure) {
    stdout.write(`${done} cases in ${seconds().toFixed(0)} s: every law held.\n`);
    return 0;
  }
  stderr.write(`Broken: ${failure.law}\n${failure.report}\n`);
  stderr.write(`To see it again: npm run fuzz -- --seed ${failure.seed} --cases ${cases}\n`);
  return 1;
}

if (argv[1] === fileURLToPath(import.meta.url)) exit(await main());
