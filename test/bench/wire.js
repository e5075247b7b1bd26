// How long the client takes for a job on a line of a given speed, as a multiple of the time that the bytes alone take.

import { TimerClient } from '../../dist/lib/client/index.js';
import { VirtualClock, wireTime } from '../../dist/lib/line/index.js';
import { exchangeSize } from '../../dist/lib/protocol/index.js';
import { VirtualTimer } from '../../dist/lib/simulator/index.js';

/**
 * @typedef {import('../../dist/lib/protocol/index.js').CommandName} CommandName
 * @typedef {{ job: string, baud: number, latencyMs: number, ratio: number }} WireResult
 */

/** @type {readonly CommandName[]} */
const CONTENT = ['GETTIMERS', 'GETSERVOPOS'];
/** Behind what a memory holds: is it still this one, and still this timer? @type {readonly CommandName[]} */
const END = ['GETMEMORY', 'GETSWVER'];
/** Identifying, and the reading. @type {readonly CommandName[]} */
const READ = ['GETSWVER', 'GETMEMORY', ...CONTENT, ...END];
/** What the timer holds before the first value is written. @type {readonly CommandName[]} */
const FRESH = ['GETSWVER', 'GETMEMORY', ...CONTENT, ...END];
/** Two readings that agree, between two questions each for timer and memory. @type {readonly CommandName[]} */
const VERIFY = ['GETSWVER', 'GETMEMORY', ...CONTENT, ...CONTENT, ...END];

/**
 * @param {number} baud
 * @param {number} latencyMs from a whole request to the first byte of its reply
 * @returns {Promise<WireResult[]>}
 */
export async function wire(baud, latencyMs) {
  const clock = new VirtualClock();
  const timer = new VirtualTimer({ clock, baudRate: baud, latency: latencyMs });
  const client = new TimerClient(timer, { clock, baudRate: baud });

  /**
   * @template T
   * @param {string} job
   * @param {readonly CommandName[]} needed the requests that there is no way around
   * @param {() => Promise<T>} work
   */
  const measure = async (job, needed, work) => {
    const begin = clock.now();
    const result = await clock.run(work());
    const sizes = needed.map((name) => exchangeSize(name, timer.core.identity));
    const bytes = sizes.reduce((sum, { request, reply }) => sum + request + reply, 0);
    const ratio = (clock.now() - begin) / wireTime(bytes, baud);
    return { result, row: { job, baud, latencyMs, ratio: Number(ratio.toFixed(4)) } };
  };

  const read = await measure('read-all', READ, () => client.readProgram());
  const baseline = read.result;
  const goal = {
    ...baseline,
    times: baseline.times.map((time) => time + 1),
    positions: baseline.positions.map((row) => row.map((position) => position + 1)),
  };
  const servos = goal.positions.flatMap((row) => row.map(() => /** @type {const} */ ('SETSERVO')));
  const write = await measure('write-and-verify', [...FRESH, 'SETTIMERS', ...servos, ...VERIFY], () =>
    client.writeProgram(goal, { baseline }),
  );
  if (write.result.result !== 'verified')
    throw new Error(`the write must end as verified, but it ended as ${write.result.result}`);
  await client.close();
  return [read.row, write.row];
}
