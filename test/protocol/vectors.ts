import type { Identity } from '../../src/protocol/index.js';

/** The timer of the source's example: B, firmware 536, 10 functions, 4 memories, 3 servos. */
export const B536: Identity = { timerClass: 'B', firmware: '536', functions: 10, memories: 4, servos: 3 };
/** The smallest timer there can be. */
export const SMALL: Identity = { timerClass: 'Q', firmware: '001', functions: 1, memories: 1, servos: 1 };
/** As many functions as a frame of times can carry. */
export const LARGE: Identity = { timerClass: 'E', firmware: '999', functions: 125, memories: 255, servos: 2 };

/** What a servo's eleven positions were in the one reply that is known from a real timer. */
export const CAPTURED_POSITIONS = [15, 25, 35, 45, 55, 65, 75, 85, 95, 105, 115];
/** That reply as it came: 42 bytes in seven pieces. */
export const CAPTURE =
  '00 00 00 00 00 24 68 0f 19 23 2d 37 41 4b 55 5f 69 73 0f 19 23 2d 37 41 4b 55 5f 69 73 0f 19 23 2d 37 41 4b 55 5f 69 73 c9 45';
export const CAPTURE_PIECES = [1, 1, 10, 9, 10, 10, 1];
