import { describe, expect, it } from 'vitest';
import {
  answers,
  COMMAND_NAMES,
  COMMANDS,
  CodecError,
  type CodecErrorCode,
  commandOf,
  decodeReply,
  decodeRequest,
  encodeFrame,
  encodeReply,
  encodeRequest,
  exchangeSize,
  type Frame,
  FrameDecoder,
  type Reply,
  type Request,
} from '../../src/protocol/index.js';
import { fromHex, toHex } from '../tools/bytes.js';
import { B536, LARGE, REPLIES, REQUESTS, SMALL } from './vectors.js';

function onlyFrame(hex: string): Frame {
  const frames = new FrameDecoder().push(fromHex(hex));
  expect(frames).toHaveLength(1);
  return frames[0] as Frame;
}

function refusal(action: () => unknown): [CodecErrorCode, string] {
  try {
    action();
  } catch (error) {
    if (error instanceof CodecError) return [error.code, error.field];
    throw error;
  }
  throw new Error('nothing was refused');
}

describe('the table of commands', () => {
  it('has 24 letters: requests odd, replies the next', () => {
    const letters = COMMAND_NAMES.flatMap((name) => [COMMANDS[name].request, COMMANDS[name].reply]);
    expect(letters.sort((a, b) => a - b)).toEqual(Array.from({ length: 24 }, (_, i) => 0x61 + i));
    for (const name of COMMAND_NAMES) expect(COMMANDS[name].reply).toBe(COMMANDS[name].request + 1);
  });

  it('never lets a command be repeated that moves something or whose effect is unknown', () => {
    expect(COMMAND_NAMES.filter((name) => !COMMANDS[name].repeatable)).toEqual(['MOVETOFUNC', 'UNLOCK', 'JUMP2']);
  });

  it('finds a command by either of its letters and no other', () => {
    expect(commandOf(0x6b)).toEqual({ name: 'GETSWVER', direction: 'request' });
    expect(commandOf(0x6c)).toEqual({ name: 'GETSWVER', direction: 'reply' });
    expect(commandOf(0x60)).toBeUndefined();
    expect(commandOf(0x79)).toBeUndefined();
  });

  it('is covered by the vectors below', () => {
    expect(new Set(REQUESTS.map((v) => v.message.name))).toEqual(new Set(COMMAND_NAMES));
    expect(new Set(REPLIES.map((v) => v.message.name))).toEqual(new Set(COMMAND_NAMES));
  });
});

describe('requests', () => {
  for (const { name, hex, identity, message } of REQUESTS) {
    it(`${name}: values to bytes`, () => expect(toHex(encodeRequest(message, { identity }))).toBe(hex));
    it(`${name}: bytes to values`, () => expect(decodeRequest(onlyFrame(hex), { identity })).toEqual(message));
  }
});

describe('replies', () => {
  for (const { name, hex, identity, message } of REPLIES) {
    it(`${name}: values to bytes`, () => expect(toHex(encodeReply(message, { identity }))).toBe(hex));
    it(`${name}: bytes to values`, () => {
      expect(decodeReply(onlyFrame(hex), { identity, pending: message.name })).toEqual(message);
      expect(decodeReply(onlyFrame(hex), { identity })).toEqual(message);
    });
  }
});

describe('values that no frame may carry', () => {
  const bad: [string, Request, CodecErrorCode, string][] = [
    [
      'a position past the last step',
      { name: 'SETSERVO', function: 0, servo: 0, position: 131 },
      'out-of-range',
      'position',
    ],
    ['a negative position', { name: 'SETSERVO', function: 0, servo: 0, position: -1 }, 'out-of-range', 'position'],
    ['half a step', { name: 'SETSERVO', function: 0, servo: 0, position: 0.5 }, 'not-an-integer', 'position'],
    ['a servo the timer has not', { name: 'SETSERVO', function: 0, servo: 3, position: 0 }, 'out-of-range', 'servo'],
    ['a function behind DT', { name: 'SETSERVO', function: 11, servo: 0, position: 0 }, 'out-of-range', 'function'],
    ['a move behind DT', { name: 'MOVETOFUNC', function: 11 }, 'out-of-range', 'function'],
    ['a memory the timer has not', { name: 'SETMEMORY', memory: 4 }, 'out-of-range', 'memory'],
    ['655.36 s', { name: 'SETTIMERS', times: [0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 65536] }, 'out-of-range', 'times[10]'],
    [
      'not a number',
      { name: 'SETTIMERS', times: [0, Number.NaN, 0, 0, 0, 0, 0, 0, 0, 0, 0] },
      'not-an-integer',
      'times[1]',
    ],
    ['ten times for eleven columns', { name: 'SETTIMERS', times: Array<number>(10).fill(0) }, 'wrong-count', 'times'],
    ['idle throttle past one byte', { name: 'SETLOWRPM', idleThrottle: 256 }, 'out-of-range', 'idleThrottle'],
  ];
  for (const [name, request, code, field] of bad) {
    it(name, () => expect(refusal(() => encodeRequest(request, { identity: B536 }))).toEqual([code, field]));
  }

  it('positions that do not have the shape of the timer', () => {
    const reply = (positions: number[][]): Reply => ({ name: 'GETSERVOPOS', positions });
    const encode = (positions: number[][]) => () => encodeReply(reply(positions), { identity: SMALL });
    expect(refusal(encode([]))).toEqual(['wrong-count', 'positions']);
    expect(refusal(encode([[1, 2, 3]]))).toEqual(['wrong-count', 'positions[0]']);
    expect(refusal(encode([[1, 256]]))).toEqual(['out-of-range', 'positions[0][1]']);
  });

  it('a letter or data that no frame can hold', () => {
    expect(refusal(() => encodeFrame(256))).toEqual(['out-of-range', 'code']);
    expect(refusal(() => encodeFrame(0x6b, new Uint8Array(253)))).toEqual(['wrong-length', 'data']);
    expect(encodeFrame(0x6b, new Uint8Array(252))).toHaveLength(261);
  });
});

describe('frames that no reply can be', () => {
  const bad: [string, string, CodecErrorCode, string][] = [
    ['an odd letter', '00 00 00 00 00 03 6b 6b 45', 'unknown-command', 'code'],
    ['a letter of nobody', '00 00 00 00 00 03 7a 7a 45', 'unknown-command', 'code'],
    ['a version of eight bytes', '00 00 00 00 00 0b 6c 42 35 33 36 20 0a 04 03 7d 45', 'wrong-length', 'data'],
    [
      'a version with no functions',
      '00 00 00 00 00 0c 6c 42 35 33 36 20 00 04 03 20 93 45',
      'bad-identity',
      'identity.functions',
    ],
    [
      'a version with no memories',
      '00 00 00 00 00 0c 6c 42 35 33 36 20 0a 00 03 20 99 45',
      'bad-identity',
      'identity.memories',
    ],
    [
      'a version with no servos',
      '00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 00 20 9a 45',
      'bad-identity',
      'identity.servos',
    ],
    [
      'a version with too many functions',
      '00 00 00 00 00 0c 6c 42 35 33 36 20 7e 04 01 20 0f 45',
      'bad-identity',
      'identity.functions',
    ],
    [
      'a version with too many servos',
      '00 00 00 00 00 0c 6c 42 35 33 36 20 0a 04 17 20 b1 45',
      'bad-identity',
      'identity.servos',
    ],
    [
      'a version without its separator',
      '00 00 00 00 00 0c 6c 42 35 33 36 21 0a 04 03 20 9e 45',
      'bad-identity',
      'identity',
    ],
    [
      'a firmware that is no number',
      '00 00 00 00 00 0c 6c 42 35 41 36 20 0a 04 03 20 ab 45',
      'bad-identity',
      'identity.firmware',
    ],
    [
      'a class that is no letter',
      '00 00 00 00 00 0c 6c 07 35 33 36 20 0a 04 03 20 62 45',
      'bad-identity',
      'identity.timerClass',
    ],
    [
      'ten times for eleven columns',
      '00 00 00 00 00 17 62 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 00 62 45',
      'wrong-length',
      'data',
    ],
    ['an acknowledgement with data', '00 00 00 00 00 04 64 01 65 45', 'wrong-length', 'data'],
    ['a memory the timer has not', '00 00 00 00 00 04 72 05 77 45', 'out-of-range', 'memory'],
    ['an idle throttle of two bytes', '00 00 00 00 00 05 76 01 01 78 45', 'wrong-length', 'data'],
    ['an idle throttle of none', '00 00 00 00 00 03 76 76 45', 'wrong-length', 'data'],
  ];
  for (const [name, hex, code, field] of bad) {
    it(name, () => expect(refusal(() => decodeReply(onlyFrame(hex), { identity: B536 }))).toEqual([code, field]));
  }

  it('positions before the timer is known', () => {
    const frame = onlyFrame('00 00 00 00 00 05 68 00 ff 67 45');
    expect(refusal(() => decodeReply(frame))).toEqual(['identity-needed', 'positions']);
  });

  it('carries the raw bytes of a version that cannot be', () => {
    const frame = onlyFrame('00 00 00 00 00 0c 6c 42 35 33 36 20 00 04 03 20 93 45');
    expect(() => decodeReply(frame)).toThrowError(expect.objectContaining({ details: { bytes: frame.data } }));
  });

  it('takes a class of another letter, for the pilot to be warned', () => {
    const frame = onlyFrame('00 00 00 00 00 0c 6c 58 35 33 36 20 0a 04 03 20 b3 45');
    expect(decodeReply(frame)).toEqual({ name: 'GETSWVER', identity: { ...B536, timerClass: 'X' } });
  });
});

describe('frames that no request can be', () => {
  it.each([
    ['a reply', '00 00 00 00 00 03 6e 6e 45', 'unknown-command', 'code'],
    ['a servo command of two bytes', '00 00 00 00 00 05 63 00 00 63 45', 'wrong-length', 'data'],
    ['a servo command of four bytes', '00 00 00 00 00 07 63 00 00 00 00 63 45', 'wrong-length', 'data'],
    ['a servo command with one byte', '00 00 00 00 00 04 63 00 63 45', 'wrong-length', 'data'],
    ['a question with data', '00 00 00 00 00 04 6b 00 6b 45', 'wrong-length', 'data'],
    ['a position past the last step', '00 00 00 00 00 06 63 00 00 83 e6 45', 'out-of-range', 'position'],
  ] satisfies [string, string, CodecErrorCode, string][])('%s', (_, hex, code, field) => {
    expect(refusal(() => decodeRequest(onlyFrame(hex), { identity: B536 }))).toEqual([code, field]);
  });
});

describe('where the source contradicts itself', () => {
  it('takes 66 for 62 and 6A for 6E, each only for the request that waits', () => {
    expect(answers(0x62, 'GETTIMERS')).toBe('exact');
    expect(answers(0x66, 'GETTIMERS')).toBe('misprint');
    expect(answers(0x6e, 'UNLOCK')).toBe('exact');
    expect(answers(0x6a, 'UNLOCK')).toBe('misprint');
    expect(answers(0x66, 'UNLOCK')).toBeUndefined();
    expect(answers(0x62, 'SETTIMERS')).toBeUndefined();
    const times = onlyFrame('00 00 00 00 00 07 66 00 00 70 17 ed 45');
    expect(decodeReply(times, { identity: SMALL, pending: 'GETTIMERS' })).toEqual({
      name: 'GETTIMERS',
      times: [0, 6000],
    });
    expect(decodeReply(times, { identity: SMALL, pending: { name: 'SETTIMERS', times: [] } })).toEqual({
      name: 'SETTIMERS',
      times: [0, 6000],
    });
    expect(refusal(() => decodeReply(times, { identity: SMALL, pending: 'GETMEMORY' }))).toEqual([
      'unexpected-reply',
      'code',
    ]);
  });

  it('sends the true checksum, or the bare one when asked', () => {
    expect(toHex(encodeRequest({ name: 'SETMEMORY', memory: 2 }))).toBe('00 00 00 00 00 04 73 02 75 45');
    expect(toHex(encodeRequest({ name: 'SETMEMORY', memory: 2 }, { bareChecksum: true }))).toBe(
      '00 00 00 00 00 04 73 02 73 45',
    );
  });

  it('reads times with the high byte first when asked', () => {
    const options = { identity: SMALL, quirks: { bigEndianTimes: true } };
    const hex = '00 00 00 00 00 07 62 00 01 17 70 ea 45';
    expect(toHex(encodeReply({ name: 'GETTIMERS', times: [1, 6000] }, options))).toBe(hex);
    expect(decodeReply(onlyFrame(hex), options)).toEqual({ name: 'GETTIMERS', times: [1, 6000] });
  });

  it('sends servo before function when asked', () => {
    const request: Request = { name: 'SETSERVO', function: 10, servo: 2, position: 65 };
    const options = { identity: B536, quirks: { servoFirst: true } };
    expect(toHex(encodeRequest(request, options))).toBe('00 00 00 00 00 06 63 02 0a 41 b0 45');
    expect(decodeRequest(onlyFrame('00 00 00 00 00 06 63 02 0a 41 b0 45'), options)).toEqual(request);
  });
});

describe('the size of an exchange', () => {
  it.each([...REQUESTS.filter((v) => v.identity === undefined || v.identity === B536)])('$name', ({ hex, message }) => {
    expect(exchangeSize(message.name, B536).request).toBe(fromHex(hex).length);
  });
  it.each(REPLIES.filter((v) => v.identity === B536))('reply to $name', ({ hex, message }) => {
    expect(exchangeSize(message.name, B536).reply).toBe(fromHex(hex).length);
  });
  it('fits the longest frame for the largest timer', () => {
    expect(exchangeSize('SETTIMERS', LARGE).request).toBe(261);
  });
});
