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
} from '../../src/protocol/index.js';
import { fromHex, toHex } from '../tools/bytes.js';
import { optionsOf, type Row, table } from './table.js';
import { B536, LARGE, SMALL } from './vectors.js';

function onlyFrame(hex: string, bareChecksum = false): Frame {
  const bytes = fromHex(hex);
  const quirks = { bareChecksum: bareChecksum && [bytes[6] as number] };
  const frames = new FrameDecoder({ quirks }).push(bytes);
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
  it('has 24 letters: odd ones for requests, the next ones for their replies', () => {
    const letters = COMMAND_NAMES.flatMap((name) => [COMMANDS[name].request, COMMANDS[name].reply]);
    expect(letters.sort((a, b) => a - b)).toEqual(Array.from({ length: 24 }, (_, i) => 0x61 + i));
    for (const name of COMMAND_NAMES) expect(COMMANDS[name].reply).toBe(COMMANDS[name].request + 1);
  });

  it('never lets a command be repeated that moves something or whose effect is unknown', () => {
    expect(COMMAND_NAMES.filter((name) => !COMMANDS[name].repeatable)).toEqual(['MOVETOFUNC', 'UNLOCK', 'JUMP2']);
    const harmless = ['reads', 'stores'];
    for (const name of COMMAND_NAMES) expect(harmless.includes(COMMANDS[name].effect)).toBe(COMMANDS[name].repeatable);
    expect(COMMANDS.UNLOCK.effect).toBe('frees-motor');
  });

  it('finds a command by either of its letters and no other', () => {
    expect(commandOf(0x6b)).toEqual({ name: 'GETSWVER', direction: 'request' });
    expect(commandOf(0x6c)).toEqual({ name: 'GETSWVER', direction: 'reply' });
    expect(commandOf(0x60)).toBeUndefined();
    expect(commandOf(0x79)).toBeUndefined();
  });

  it('is covered by the vectors', () => {
    expect(new Set(table.requests.map((row) => row.message.name))).toEqual(new Set(COMMAND_NAMES));
    expect(new Set(table.replies.map((row) => row.message.name))).toEqual(new Set(COMMAND_NAMES));
  });
});

describe('requests', () => {
  for (const row of table.requests) {
    const { name, hex, message } = row;
    const options = optionsOf(row);
    const frame = (): Frame => onlyFrame(hex, options.bareChecksum);
    it(`${name}: values to bytes`, () => expect(toHex(encodeRequest(message, options))).toBe(hex));
    it(`${name}: bytes to values`, () => expect(decodeRequest(frame(), options)).toEqual(message));
  }
});

describe('replies', () => {
  for (const row of table.replies) {
    const { name, hex, message } = row;
    const options = optionsOf(row);
    const frame = (): Frame => onlyFrame(hex, options.bareChecksum);
    it(`${name}: values to bytes`, () => expect(toHex(encodeReply(message, options))).toBe(hex));
    it(`${name}: bytes to values`, () => {
      expect(decodeReply(frame(), { ...options, pending: message.name })).toEqual(message);
      expect(decodeReply(frame(), options)).toEqual(message);
    });
  }
});

describe('values that no frame can carry', () => {
  it.each(table.badValues)('$direction: $name', (row) => {
    const encode = row.direction === 'request' ? encodeRequest : encodeReply;
    expect(refusal(() => encode(row.message, optionsOf(row)))).toEqual([row.code, row.field]);
  });

  it('values that no text of vectors can hold', () => {
    const encode = (time: number) => () => encodeRequest({ name: 'SETTIMERS', times: [0, time] }, { identity: SMALL });
    expect(refusal(encode(Number.NaN))).toEqual(['not-an-integer', 'times[1]']);
    expect(refusal(encode(Number.POSITIVE_INFINITY))).toEqual(['not-an-integer', 'times[1]']);
  });

  it('a letter or data that no frame can hold', () => {
    expect(refusal(() => encodeFrame(256))).toEqual(['out-of-range', 'code']);
    expect(refusal(() => encodeFrame(-1))).toEqual(['out-of-range', 'code']);
    expect(refusal(() => encodeFrame(0x6b, [0, 256]))).toEqual(['out-of-range', 'data[1]']);
    expect(refusal(() => encodeFrame(0x6b, new Uint8Array(253)))).toEqual(['wrong-length', 'data']);
    expect(encodeFrame(0x6b, new Uint8Array(252))).toHaveLength(261);
  });
});

describe('frames that can be neither request nor reply', () => {
  it.each(table.badHex)('$direction: $name', (row) => {
    const { direction, hex, pending, code, field } = row;
    const decode = () =>
      direction === 'request'
        ? decodeRequest(onlyFrame(hex), optionsOf(row))
        : decodeReply(onlyFrame(hex), { ...optionsOf(row), pending });
    expect(refusal(decode)).toEqual([code, field]);
  });

  it('carries the raw bytes of an impossible version', () => {
    const frame = onlyFrame('00 00 00 00 00 0c 6c 42 35 33 36 20 00 04 03 20 93 45');
    expect(() => decodeReply(frame)).toThrowError(expect.objectContaining({ details: { bytes: frame.data } }));
  });
});

it('66 for 62 and 6A for 6E are accepted, each only as the reply to its own request', () => {
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

const identity = { ...SMALL, memories: 255 };
it.each([
  ['a timer that counts from 1 and is not known to', 255, false],
  ['one that is', 254, true],
])('the last of 255 memories comes back as it was from %s', (_, memory, memoriesFromOne) => {
  const options = { identity, quirks: { memoriesFromOne } };
  const bytes = encodeReply({ name: 'GETMEMORY', memory }, options);
  expect(toHex(bytes)).toBe('00 00 00 00 00 04 72 ff 71 45');
  expect(decodeReply(onlyFrame(toHex(bytes)), options)).toEqual({ name: 'GETMEMORY', memory });
});

describe('the size of an exchange', () => {
  const ofB536 = <T extends Row<unknown>>(rows: readonly T[]): T[] =>
    rows.filter(({ identity }) => JSON.stringify(identity) === JSON.stringify(B536));
  const withoutData = table.requests.filter(({ hex }) => fromHex(hex).length === 9);
  it.each([...ofB536(table.requests), ...withoutData])('$name', ({ hex, message }) => {
    expect(exchangeSize(message.name, B536).request).toBe(fromHex(hex).length);
  });
  it.each(ofB536(table.replies))('reply to $name', ({ hex, message }) => {
    expect(exchangeSize(message.name, B536).reply).toBe(fromHex(hex).length);
  });
  it('counts what may be missing, and uses the identity of the timer', () => {
    expect([exchangeSize('GETSWVER', B536), exchangeSize('GETLOWRPM', B536)]).toEqual([
      { request: 9, reply: 18 },
      { request: 9, reply: 10 },
    ]);
  });
  it('fits the longest frame for the largest timer', () => {
    expect(exchangeSize('SETTIMERS', LARGE).request).toBe(261);
  });
});
