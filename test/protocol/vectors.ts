import type { Identity, Reply, Request } from '../../src/protocol/index.js';

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

interface Vector<Message> {
  readonly name: string;
  readonly hex: string;
  readonly identity?: Identity;
  readonly message: Message;
}

const times = [0, 69, 256, 300, 400, 500, 600, 700, 800, 900, 65535];

export const REQUESTS: readonly Vector<Request>[] = [
  { name: 'GETTIMERS', hex: '00 00 00 00 00 03 61 61 45', message: { name: 'GETTIMERS' } },
  {
    name: 'SETSERVO, all zero',
    hex: '00 00 00 00 00 06 63 00 00 00 63 45',
    identity: B536,
    message: { name: 'SETSERVO', function: 0, servo: 0, position: 0 },
  },
  {
    name: 'SETSERVO, DT of S3 to its last step',
    hex: '00 00 00 00 00 06 63 0a 02 82 f1 45',
    identity: B536,
    message: { name: 'SETSERVO', function: 10, servo: 2, position: 130 },
  },
  {
    name: 'SETTIMERS, with 45 00 and ff ff inside',
    hex: '00 00 00 00 00 19 65 00 00 45 00 00 01 2c 01 90 01 f4 01 58 02 bc 02 20 03 84 03 ff ff 1e 45',
    identity: B536,
    message: { name: 'SETTIMERS', times },
  },
  {
    name: 'SETTIMERS, two times',
    hex: '00 00 00 00 00 07 65 00 00 70 17 ec 45',
    identity: SMALL,
    message: { name: 'SETTIMERS', times: [0, 6000] },
  },
  { name: 'GETSERVOPOS', hex: '00 00 00 00 00 03 67 67 45', message: { name: 'GETSERVOPOS' } },
  {
    name: 'MOVETOFUNC, DT',
    hex: '00 00 00 00 00 04 69 0a 73 45',
    identity: B536,
    message: { name: 'MOVETOFUNC', function: 10 },
  },
  { name: 'GETSWVER', hex: '00 00 00 00 00 03 6b 6b 45', message: { name: 'GETSWVER' } },
  { name: 'UNLOCK', hex: '00 00 00 00 00 03 6d 6d 45', message: { name: 'UNLOCK' } },
  { name: 'JUMP2', hex: '00 00 00 00 00 03 6f 6f 45', message: { name: 'JUMP2' } },
  { name: 'GETMEMORY', hex: '00 00 00 00 00 03 71 71 45', message: { name: 'GETMEMORY' } },
  {
    name: 'SETMEMORY, the first',
    hex: '00 00 00 00 00 04 73 00 73 45',
    identity: B536,
    message: { name: 'SETMEMORY', memory: 0 },
  },
  {
    name: 'SETMEMORY, the last',
    hex: '00 00 00 00 00 04 73 03 76 45',
    identity: B536,
    message: { name: 'SETMEMORY', memory: 3 },
  },
  { name: 'GETLOWRPM', hex: '00 00 00 00 00 03 75 75 45', message: { name: 'GETLOWRPM' } },
  { name: 'SETLOWRPM', hex: '00 00 00 00 00 04 77 ff 76 45', message: { name: 'SETLOWRPM', idleThrottle: 255 } },
];

export const REPLIES: readonly Vector<Reply>[] = [
  {
    name: 'GETTIMERS',
    hex: '00 00 00 00 00 19 62 00 00 45 00 00 01 2c 01 90 01 f4 01 58 02 bc 02 20 03 84 03 ff ff 1b 45',
    identity: B536,
    message: { name: 'GETTIMERS', times },
  },
  { name: 'SETSERVO', hex: '00 00 00 00 00 03 64 64 45', message: { name: 'SETSERVO' } },
  {
    name: 'SETTIMERS',
    hex: '00 00 00 00 00 19 66 00 00 45 00 00 01 2c 01 90 01 f4 01 58 02 bc 02 20 03 84 03 ff ff 1f 45',
    identity: B536,
    message: { name: 'SETTIMERS', times },
  },
  {
    name: 'GETSERVOPOS, from a real timer',
    hex: CAPTURE,
    identity: B536,
    message: { name: 'GETSERVOPOS', positions: [CAPTURED_POSITIONS, CAPTURED_POSITIONS, CAPTURED_POSITIONS] },
  },
  {
    name: 'GETSERVOPOS, with a position that cannot be set',
    hex: '00 00 00 00 00 05 68 00 ff 67 45',
    identity: SMALL,
    message: { name: 'GETSERVOPOS', positions: [[0, 255]] },
  },
  { name: 'MOVETOFUNC', hex: '00 00 00 00 00 03 6a 6a 45', message: { name: 'MOVETOFUNC' } },
  {
    name: 'GETSWVER, from the source',
    hex: '00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 03 20 9d 45',
    message: { name: 'GETSWVER', identity: B536 },
  },
  {
    name: 'GETSWVER, the largest',
    hex: '00 00 00 00 00 0c 6c 45 39 39 39 20 7d ff 02 20 1a 45',
    message: { name: 'GETSWVER', identity: LARGE },
  },
  { name: 'UNLOCK', hex: '00 00 00 00 00 03 6e 6e 45', message: { name: 'UNLOCK' } },
  { name: 'JUMP2', hex: '00 00 00 00 00 03 70 70 45', message: { name: 'JUMP2' } },
  {
    name: 'GETMEMORY',
    hex: '00 00 00 00 00 04 72 03 75 45',
    identity: B536,
    message: { name: 'GETMEMORY', memory: 3 },
  },
  {
    name: 'GETMEMORY, counted from 1',
    hex: '00 00 00 00 00 04 72 04 76 45',
    identity: B536,
    message: { name: 'GETMEMORY', memory: 4 },
  },
  { name: 'GETMEMORY, no index', hex: '00 00 00 00 00 03 72 72 45', message: { name: 'GETMEMORY', memory: null } },
  { name: 'SETMEMORY', hex: '00 00 00 00 00 03 74 74 45', message: { name: 'SETMEMORY' } },
  { name: 'GETLOWRPM', hex: '00 00 00 00 00 04 76 1e 94 45', message: { name: 'GETLOWRPM', idleThrottle: 30 } },
  { name: 'SETLOWRPM', hex: '00 00 00 00 00 03 78 78 45', message: { name: 'SETLOWRPM' } },
];
