export { BITS_PER_BYTE, ByteLine, type ByteLineOptions, wireTime } from './byte-line.js';
export { type Clock, realClock, VirtualClock } from './clock.js';
