import { describe, expect, it } from 'vitest';
import {
  type CaptureEntry,
  COMMANDS,
  type CodecErrorDetails,
  decodeReply,
  decodeRequest,
  encodeFrame,
  encodeReply,
  encodeRequest,
  formatCapture,
  type Identity,
  parseCapture,
  type Request,
  requireIdentity,
} from '../../src/protocol/index.js';
import { refusalOf } from '../program/refusal.js';

const identity: Identity = { timerClass: 'Q', firmware: '536', functions: 2, memories: 4, servos: 1 };
const of = (other: object): Identity => ({ ...identity, ...other });
const bytes = (...data: number[]) => Uint8Array.from(data);

const timesOf = (times: readonly number[]) => encodeRequest({ name: 'SETTIMERS', times }, { identity });

/** What is refused is named with its place and its figures, so that a program can say it in its own words. */
it.each<[string, CodecErrorDetails, () => unknown]>([
  [
    'out-of-range position must be 0 to 130, not 131',
    { value: 131, min: 0, max: 130 },
    () => encodeRequest({ name: 'SETSERVO', function: 0, servo: 0, position: 131 }, { identity }),
  ],
  ['not-an-integer times[1] must be a whole number, not 2.5', { value: 2.5 }, () => timesOf([1, 2.5, 3])],
  [
    'not-an-integer idleThrottle must be a whole number, not string',
    { value: '7' },
    () => encodeRequest({ name: 'SETLOWRPM', idleThrottle: '7' as unknown as number }),
  ],
  [
    'out-of-range idleThrottle must be 0 to 255, not 256',
    { value: 256, min: 0, max: 255 },
    () => encodeReply({ name: 'GETLOWRPM', idleThrottle: 256 }),
  ],
  [
    'out-of-range memory must be -1 to 254, not 255',
    { value: 255, min: -1, max: 254 },
    () => encodeReply({ name: 'GETMEMORY', memory: 255 }, { quirks: { memoriesFromOne: true } }),
  ],
  ['wrong-count times must have 3 entries, not 2', { value: 2, min: 3, max: 3 }, () => timesOf([1, 2])],
  ['wrong-type times must be a list', { value: 5 }, () => timesOf(5 as unknown as number[])],
  ['wrong-type data: no list of bytes', {}, () => encodeFrame(0x61, {} as number[])],
  [
    'wrong-length data: a frame carries at most 252 bytes, not 253',
    { max: 252 },
    () => encodeFrame(0x61, new Uint8Array(253)),
  ],
  [
    'wrong-length data: expected 1 to 1 bytes, got 2',
    { bytes: bytes(1, 2), min: 1, max: 1 },
    () => decodeReply({ code: 0x76, data: bytes(1, 2) }),
  ],
  [
    // Whatever the first of its values is.
    'wrong-length data: 1 bytes do not fit this command',
    { bytes: bytes(200) },
    () => decodeRequest({ code: COMMANDS.SETSERVO.request, data: bytes(200) }, { identity }),
  ],
  [
    'wrong-length data: times are two bytes each, got 3',
    { bytes: bytes(1, 2, 3) },
    () => decodeReply({ code: 0x62, data: bytes(1, 2, 3) }),
  ],
  [
    'unexpected-reply code: a reply to GETSWVER does not answer GETTIMERS',
    { value: 0x6c },
    () => decodeReply({ code: 0x6c, data: bytes() }, { pending: 'GETTIMERS' }),
  ],
  ['unknown-command code: no such command: 05', { value: 5 }, () => decodeReply({ code: 0x05, data: bytes() })],
  [
    'unknown-command name: a message must have the name of a command',
    { value: 'toString' },
    () => encodeRequest({ name: 'toString' } as unknown as Request),
  ],
  [
    'wrong-length data: a version is 9 bytes, not 2',
    { bytes: bytes(0x42, 0x35) },
    () => decodeReply({ code: 0x6c, data: bytes(0x42, 0x35) }),
  ],
  [
    'bad-capture entry 1: entry 1: it must have bytes',
    {},
    () => formatCapture([{ time: 0, direction: 'in', bytes: bytes(1) }, { time: 1, direction: 'in' } as CaptureEntry]),
  ],
  [
    'bad-capture line 2: line 2: expected a time in seconds, < or >, and bytes in hex',
    {},
    () => parseCapture('# Sidus capture 1\n0.1 00'),
  ],
  [
    'bad-capture line 1: line 1: the first line must be “# Sidus capture 1”',
    {},
    () => parseCapture('# Sidus capture 2'),
  ],
])('a refusal names the place and the limits: %s: %o', (refusal, details, work) => {
  expect(refusalOf(work)).toEqual([refusal, details]);
});

describe('an impossible identity', () => {
  it.each<[string, object, string, string]>([
    ['a class of two letters', { timerClass: 'BQ' }, 'timerClass', 'the class must be one printable character'],
    ['a class that is a number', { timerClass: 7 }, 'timerClass', 'the class must be one printable character'],
    ['firmware of four digits', { firmware: '5367' }, 'firmware', 'the firmware must be three characters'],
    ['firmware after a letter', { firmware: 'v536' }, 'firmware', 'the firmware must be three characters'],
    ['firmware that is a number', { firmware: 536 }, 'firmware', 'the firmware must be three characters'],
    ['more memories than a byte counts', { memories: 256 }, 'memories', 'memories must be 1 to 255'],
    ['no servo', { servos: 0 }, 'servos', 'servos must be 1 to 255'],
  ])('%s is refused', (_, other, field, message) => {
    expect(refusalOf(() => requireIdentity(of(other)))).toEqual([`bad-identity identity.${field}: ${message}`, {}]);
  });

  it('255 memories are the most', () => {
    expect(refusalOf(() => requireIdentity(of({ memories: 255 })))).toBeUndefined();
  });

  it.each<unknown>([undefined, null, 'Q536', 5])('%s is not an identity', (value) => {
    const message = 'wrong-type identity: an identity must be an object';
    expect(refusalOf(() => requireIdentity(value as Identity))).toEqual([message, { value }]);
  });
});
