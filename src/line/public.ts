/**
 * A clock that can be turned by hand, and a byte line with speed, delay, chunks and faults.
 * @module line
 */

export type { ByteLineOptions, Bytes } from './byte-line.js';
export { type Clock, VirtualClock } from './clock.js';
