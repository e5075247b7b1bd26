import { describe, expect, it } from 'vitest';
import {
  type CaptureEntry,
  COMMANDS,
  type CodecError,
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

type Refusal = [code: CodecError['code'], field: string, message: string, details: CodecErrorDetails];

/** What is refused is named with its place and its figures, so that a program can say it in its own words. */
describe('a refusal names the place and the limits', () => {
  it.each<[string, () => unknown, Refusal]>([
    [
      'a position beyond the last step',
      () => encodeRequest({ name: 'SETSERVO', function: 0, servo: 0, position: 131 }, { identity }),
      ['out-of-range', 'position', 'position must be 0 to 130, not 131', { value: 131, min: 0, max: 130 }],
    ],
    [
      'a time with a fraction',
      () => encodeRequest({ name: 'SETTIMERS', times: [1, 2.5, 3] }, { identity }),
      ['not-an-integer', 'times[1]', 'times[1] must be a whole number, not 2.5', { value: 2.5 }],
    ],
    [
      'a text where a number belongs',
      () => encodeRequest({ name: 'SETLOWRPM', idleThrottle: '7' as unknown as number }),
      ['not-an-integer', 'idleThrottle', 'idleThrottle must be a whole number, not string', { value: '7' }],
    ],
    [
      'an idle throttle that no byte holds',
      () => encodeReply({ name: 'GETLOWRPM', idleThrottle: 256 }),
      ['out-of-range', 'idleThrottle', 'idleThrottle must be 0 to 255, not 256', { value: 256, min: 0, max: 255 }],
    ],
    [
      'a memory that no byte holds when they count from 1',
      () => encodeReply({ name: 'GETMEMORY', memory: 255 }, { quirks: { memoriesFromOne: true } }),
      ['out-of-range', 'memory', 'memory must be -1 to 254, not 255', { value: 255, min: -1, max: 254 }],
    ],
    [
      'too few times',
      () => encodeRequest({ name: 'SETTIMERS', times: [1, 2] }, { identity }),
      ['wrong-count', 'times', 'times must have 3 entries, not 2', { value: 2, min: 3, max: 3 }],
    ],
    [
      'no list of times',
      () => encodeRequest({ name: 'SETTIMERS', times: 5 as unknown as number[] }),
      ['wrong-type', 'times', 'times must be a list', { value: 5 }],
    ],
    [
      'a frame without a list of bytes',
      () => encodeFrame(0x61, {} as number[]),
      ['wrong-type', 'data', 'no list of bytes', {}],
    ],
    [
      'more data than a frame carries',
      () => encodeFrame(0x61, new Uint8Array(253)),
      ['wrong-length', 'data', 'a frame carries at most 252 bytes, not 253', { max: 252 }],
    ],
    [
      'data of another length than its value has',
      () => decodeReply({ code: 0x76, data: bytes(1, 2) }),
      ['wrong-length', 'data', 'expected 1 to 1 bytes, got 2', { bytes: bytes(1, 2), min: 1, max: 1 }],
    ],
    [
      'data too short for its values, whatever the first of them is',
      () => decodeRequest({ code: COMMANDS.SETSERVO.request, data: bytes(200) }, { identity }),
      ['wrong-length', 'data', '1 bytes do not fit this command', { bytes: bytes(200) }],
    ],
    [
      'half a time',
      () => decodeReply({ code: 0x62, data: bytes(1, 2, 3) }),
      ['wrong-length', 'data', 'times are two bytes each, got 3', { bytes: bytes(1, 2, 3) }],
    ],
    [
      'a reply to something else',
      () => decodeReply({ code: 0x6c, data: bytes() }, { pending: 'GETTIMERS' }),
      ['unexpected-reply', 'code', 'a reply to GETSWVER does not answer GETTIMERS', { value: 0x6c }],
    ],
    [
      'a letter that no command has',
      () => decodeReply({ code: 0x05, data: bytes() }),
      ['unknown-command', 'code', 'no such command: 05', { value: 5 }],
    ],
    [
      'a request of no name',
      () => encodeRequest({ name: 'toString' } as unknown as Request),
      ['unknown-command', 'name', 'a message must have the name of a command', { value: 'toString' }],
    ],
    [
      'a version of another length',
      () => decodeReply({ code: 0x6c, data: bytes(0x42, 0x35) }),
      ['wrong-length', 'data', 'a version is 9 bytes, not 2', { bytes: bytes(0x42, 0x35) }],
    ],
    [
      'an entry of a capture',
      () =>
        formatCapture([{ time: 0, direction: 'in', bytes: bytes(1) }, { time: 1, direction: 'in' } as CaptureEntry]),
      ['bad-capture', 'entry 1', 'entry 1: it must have bytes', {}],
    ],
    [
      'a line of a capture',
      () => parseCapture('# Sidus capture 1\n0.1 00'),
      ['bad-capture', 'line 2', 'line 2: expected a time in seconds, < or >, and bytes in hex', {}],
    ],
    [
      'a text that is no capture',
      () => parseCapture('# Sidus capture 2'),
      ['bad-capture', 'line 1', 'line 1: the first line must be “# Sidus capture 1”', {}],
    ],
  ])('%s', (_, work, refusal) => {
    expect(refusalOf(work)).toEqual(refusal);
  });
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
    expect(refusalOf(() => requireIdentity(of(other)))).toEqual(['bad-identity', `identity.${field}`, message, {}]);
  });

  it('255 memories are the most', () => {
    expect(refusalOf(() => requireIdentity(of({ memories: 255 })))).toBeUndefined();
  });

  it.each<unknown>([undefined, null, 'Q536', 5])('%s is not an identity', (value) => {
    const message = 'an identity must be an object';
    expect(refusalOf(() => requireIdentity(value as Identity))).toEqual(['wrong-type', 'identity', message, { value }]);
  });
});
