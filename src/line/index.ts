/**
 * A clock that can be turned by hand, and a byte line with speed, delay, chunks and faults.
 * @module
 */

export { BITS_PER_BYTE, ByteLine, type ByteLineOptions, type Bytes, wireTime } from './byte-line.js';
export { type Clock, realClock, VirtualClock } from './clock.js';
