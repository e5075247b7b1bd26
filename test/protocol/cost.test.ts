import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { encodeFrame } from '../../src/protocol/index.js';
import { piecesAndSilence, stream } from '../fuzz/streams.js';
import { fromHex } from '../tools/bytes.js';
import { CountedDecoder } from './counting.js';

const SIZE = 65_536;

/**
 * Visits of a byte, on average, that no stream can exceed. A byte is looked at when it comes, and once more ahead of
 * that; it is held and both looks are repeated there; it is moved up once at most, and told of. Its header's sum is
 * taken once, and once more for all headers inside that one; both again after a move. A header, of which there is one
 * in five bytes at most, is compared with its ends and with the sums that are kept.
 */
const BOUND = 13;

function repeated(bytes: Uint8Array, size: number): Uint8Array {
  return Uint8Array.from({ length: size }, (_, at) => bytes[at % bytes.length] as number);
}

/** Visits that a stream costs in chunks of this size, and frames that ten good ones after it still give. */
function cost(bytes: Uint8Array, chunk: number): { perByte: number; last: number } {
  const decoder = new CountedDecoder();
  for (let at = 0; at < bytes.length; at += chunk) decoder.push(bytes.subarray(at, at + chunk));
  const perByte = decoder.counter.visited / bytes.length;
  let last = 0;
  for (let i = 0; i < 10; i++) last += decoder.push(encodeFrame(0x6b));
  return { perByte, last: last + decoder.idle() };
}

/** 51 headers that all ask for one and the same last byte, a right terminator. */
function converging(): Uint8Array {
  const bytes = new Uint8Array(256);
  for (let at = 0; at <= 250; at += 5) bytes[at] = 255 - at;
  bytes[255] = 0x45;
  return bytes;
}

/** The longest frame with a wrong sum. */
function almost(): Uint8Array {
  const bytes = encodeFrame(0x62, new Uint8Array(252).fill(0x20));
  bytes[bytes.length - 2] = 1;
  return bytes;
}

// Visits at most in one chunk, and in chunks of any size; what was measured stands at the end of the line.
const hostile: [name: string, bytes: Uint8Array, inOne: number, most: number][] = [
  ['bytes without zeros', fromHex('01'), 0.3, 2.1], // 0.25, 2.0
  ['zeros', fromHex('00'), 1.1, 1.1], // 1.0, 1.0
  ['false headers 00 00 00 00 FF', fromHex('00 00 00 00 ff'), 1.7, 4.1], // 1.60, 3.98
  ['false headers 00 00 00 00 45', fromHex('00 00 00 00 45'), 1.7, 3.2], // 1.60, 3.11
  ['false headers with a right terminator 00 00 00 00 FD 45', fromHex('00 00 00 00 fd 45'), 3.7, 7.7], // 3.47, 7.46
  ['headers that all ask for one terminator', converging(), 5.4, 5.4], // 5.28, 5.28
  ['almost-frames with right terminators and wrong sums', almost(), 2.4, 3.4], // 2.25, 3.22
];

describe('the cost of a byte', () => {
  for (const [name, bytes, inOne, most] of hostile) {
    it(`is bounded for ${name}, and ten frames after them are delivered`, () => {
      for (const chunk of [SIZE, 4096, 1]) {
        const { perByte, last } = cost(repeated(bytes, SIZE), chunk);
        expect(perByte, `visits a byte in chunks of ${chunk}`).toBeLessThanOrEqual(chunk === SIZE ? inOne : most);
        expect(last, `frames after the hostile bytes, in chunks of ${chunk}`).toBe(10);
      }
    });

    it(`does not grow with the length of a stream of ${name}`, () => {
      const short = cost(repeated(bytes, 8192), 64).perByte;
      const long = cost(repeated(bytes, 32_768), 64).perByte;
      expect(long / short).toBeLessThan(1.1);
    });
  }

  it('is small for good frames', () => {
    const bytes = repeated(encodeFrame(0x68, new Uint8Array(33).fill(7)), SIZE);
    expect(cost(bytes, SIZE).perByte).toBeLessThanOrEqual(2.1); // 2.03
    expect(cost(bytes, 1).perByte).toBeLessThanOrEqual(2.9); // 2.76
  });

  it('is bounded for any stream in any pieces, with and without callbacks', () => {
    fc.assert(
      fc.property(stream, piecesAndSilence, fc.boolean(), ({ bytes }, cut, tell) => {
        const ears = { onFrame: () => {}, onRejected: () => {} };
        const decoder = new CountedDecoder(tell ? ears : {});
        for (const { piece, silent } of cut.of(bytes)) {
          decoder.push(piece);
          if (silent) decoder.idle();
        }
        decoder.idle();
        const most = BOUND * bytes.length;
        if (decoder.counter.visited > most) throw new Error(`${decoder.counter.visited} visits, ${most} at most`);
      }),
      { numRuns: 3000 },
    );
  });
});
