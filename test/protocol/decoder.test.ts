import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { encodeFrame, type Frame, FrameDecoder, type Rejection } from '../../src/protocol/index.js';
import { concat, cut, fromHex, toHex } from '../tools/bytes.js';
import { CAPTURE, CAPTURE_PIECES } from './vectors.js';

function shown(frames: readonly Frame[]): string[] {
  return frames.map(({ code, data }) => toHex(concat(Uint8Array.of(code), data)));
}

function decode(pieces: readonly Uint8Array[], decoder = new FrameDecoder()): Frame[] {
  return [...pieces.flatMap((piece) => decoder.push(piece)), ...decoder.idle()];
}

/** The law in its plainest form, read off a stream that is there as a whole: slow, and with nothing of the decoder in it. */
function reference(stream: Uint8Array): Frame[] {
  const frames: Frame[] = [];
  let begin = 0;
  for (let at = 0; at < stream.length; at++) {
    const length = stream[at] as number;
    if (at - begin < 4 || length < 3 || at + length >= stream.length) continue;
    if (stream.subarray(at - 4, at).some((byte) => byte !== 0)) continue;
    const body = stream.subarray(at + 1, at + length - 1);
    const sum = body.reduce((total, byte) => total + byte, 0) % 256;
    if (stream[at + length] !== 0x45 || stream[at + length - 1] !== sum) continue;
    frames.push({ code: body[0] as number, data: body.slice(1) });
    begin = at + length + 1;
    at = begin - 1;
  }
  return frames;
}

describe('frames that are whole', () => {
  it('come out as they went in', () => {
    const bytes = encodeFrame(0x6c, fromHex('42 35 33 36 20 0a 04 03 20'));
    expect(new FrameDecoder().push(bytes)).toEqual([{ code: 0x6c, data: fromHex('42 35 33 36 20 0a 04 03 20') }]);
  });

  it('are found in the seven pieces in which a real timer sent one', () => {
    const pieces = cut(fromHex(CAPTURE), CAPTURE_PIECES);
    expect(pieces.map((piece) => piece.length)).toEqual(CAPTURE_PIECES);
    const decoder = new FrameDecoder();
    const frames = pieces.map((piece) => decoder.push(piece));
    expect(frames.map((found) => found.length)).toEqual([0, 0, 0, 0, 0, 0, 1]);
    expect(frames[6]?.[0]?.data).toHaveLength(33);
  });

  it('need four zeros, and may have any number more', () => {
    const rest = fromHex('03 6b 6b 45');
    for (const zeros of [0, 1, 2, 3]) expect(decode([concat(new Uint8Array(zeros), rest)])).toEqual([]);
    for (const zeros of [4, 5, 6, 1000]) expect(decode([concat(new Uint8Array(zeros), rest)])).toHaveLength(1);
  });

  it('may carry 45 and zeros inside', () => {
    expect(shown(decode([fromHex('00 00 00 00 00 09 62 45 00 00 00 00 00 a7 45')]))).toEqual(['62 45 00 00 00 00 00']);
  });

  it('own their data', () => {
    const chunk = encodeFrame(0x72, [3]);
    const [frame] = new FrameDecoder().push(chunk);
    chunk.fill(9);
    expect(frame?.data).toEqual(Uint8Array.of(3));
  });

  it('are read from a view into a larger buffer', () => {
    const buffer = new Uint8Array(64).fill(0xee);
    const bytes = encodeFrame(0x72, [3]);
    buffer.set(bytes, 7);
    expect(new FrameDecoder().push(buffer.subarray(7, 7 + bytes.length))).toEqual([
      { code: 0x72, data: Uint8Array.of(3) },
    ]);
  });
});

describe('frames that are not whole', () => {
  it('wait, and are given up when the line falls silent', () => {
    const rejected: Rejection[] = [];
    const decoder = new FrameDecoder({ onRejected: (rejection) => rejected.push(rejection) });
    expect(decoder.push(fromHex('00 00 00 00 00 24 68 0f'))).toEqual([]);
    expect(decoder.waiting).toBe(true);
    expect(rejected).toEqual([]);
    expect(decoder.idle()).toEqual([]);
    expect(decoder.waiting).toBe(false);
    expect(rejected).toEqual([{ reason: 'silence', bytes: fromHex('00 00 00 00 00 24 68 0f') }]);
  });

  it('may hide a real one, which comes out when the line falls silent', () => {
    const decoder = new FrameDecoder();
    const hidden = encodeFrame(0x6c, fromHex('42 35 33 36 20 0a 04 03 20'));
    expect(decoder.push(concat(fromHex('00 00 00 00 24 68'), hidden))).toEqual([]);
    expect(shown(decoder.idle())).toEqual(['6c 42 35 33 36 20 0a 04 03 20']);
  });

  it('are not looked into before that: times can spell a frame', () => {
    const inner = encodeFrame(0x6b);
    const outer = encodeFrame(0x62, concat(Uint8Array.of(1), inner));
    const decoder = new FrameDecoder();
    expect(decoder.push(outer.subarray(0, outer.length - 1))).toEqual([]);
    expect(decoder.push(outer.subarray(outer.length - 1))).toEqual([
      { code: 0x62, data: concat(Uint8Array.of(1), inner) },
    ]);
  });
});

describe('bytes that belong to no frame', () => {
  const cases: [string, string, [string, string][], string[]][] = [
    ['noise', '01 02 03', [['noise', '01 02 03']], []],
    ['too few zeros', '00 00 00 03 6b 6b 45', [['noise', '00 00 00 03 6b 6b 45']], []],
    ['a length of 2', '00 00 00 00 02 6b 45', [['length', '00 00 00 00 02 6b 45']], []],
    ['a wrong sum', '00 00 00 00 03 6b 6c 45', [['checksum', '00 00 00 00 03 6b 6c 45']], []],
    ['a wrong end', '00 00 00 00 03 6b 6b 46', [['terminator', '00 00 00 00 03 6b 6b 46']], []],
    [
      'noise before, between and after',
      'ff 00 00 00 00 03 6b 6b 45 00 fe 00 00 00 00 00 03 6d 6d 45 fd',
      [
        ['noise', 'ff'],
        ['noise', '00 fe'],
        ['noise', 'fd'],
      ],
      ['6b', '6d'],
    ],
    [
      'a damaged frame before a good one',
      '00 00 00 00 00 04 72 03 70 45 00 00 00 00 00 03 6b 6b 45',
      [['checksum', '00 00 00 00 00 04 72 03 70 45']],
      ['6b'],
    ],
    [
      'a damaged length that reaches into the next frame',
      '00 00 00 00 00 06 6b 6b 45 00 00 00 00 00 03 6d 6d 45',
      [['terminator', '00 00 00 00 00 06 6b 6b 45']],
      ['6d'],
    ],
  ];
  for (const [name, hex, expected, frames] of cases) {
    it(name, () => {
      const rejected: [string, string][] = [];
      const decoder = new FrameDecoder({ onRejected: ({ reason, bytes }) => rejected.push([reason, toHex(bytes)]) });
      expect(shown(decode([fromHex(hex)], decoder))).toEqual(frames);
      expect(rejected).toEqual(expected);
    });
  }
});

describe('a bare checksum', () => {
  const bare = fromHex('00 00 00 00 00 04 76 1e 76 45');
  it('is refused unless asked for', () => expect(decode([bare])).toEqual([]));
  it('is taken for 76 when asked for, and said', () => {
    const told: boolean[] = [];
    const decoder = new FrameDecoder({ quirks: { bareChecksum: true }, onFrame: (_, __, isBare) => told.push(isBare) });
    expect(shown(decode([bare, encodeFrame(0x76, [0x1e])], decoder))).toEqual(['76 1e', '76 1e']);
    expect(told).toEqual([true, false]);
  });
  it('is refused for every other letter and length', () => {
    const decoder = new FrameDecoder({ quirks: { bareChecksum: true } });
    expect(decode([fromHex('00 00 00 00 00 04 72 01 72 45')], decoder)).toEqual([]);
    expect(decode([fromHex('00 00 00 00 00 05 76 01 01 76 45')], decoder)).toEqual([]);
  });
});

describe('laws', () => {
  const frame = fc
    .record({ code: fc.integer({ min: 0, max: 255 }), data: fc.uint8Array({ maxLength: 60 }) })
    .map(({ code, data }) => encodeFrame(code, data));
  // Bytes as they make trouble: zeros, lengths, ends, headers inside data.
  const noise = fc.array(fc.constantFrom(0, 0, 0, 0, 3, 4, 9, 0x24, 0x45, 0x62, 0x6b, 0xff), { maxLength: 40 });
  const damaged = fc.tuple(frame, fc.nat(), fc.integer({ min: 0, max: 255 })).map(([bytes, where, value]) => {
    const copy = bytes.slice();
    copy[where % copy.length] = value;
    return copy;
  });
  const stream = fc
    .array(
      fc.oneof(
        frame,
        damaged,
        noise.map((bytes) => Uint8Array.from(bytes)),
      ),
      { maxLength: 8 },
    )
    .map((pieces) => concat(...pieces));
  const sizes = fc.array(fc.integer({ min: 1, max: 30 }), { maxLength: 40 });
  const runs = { numRuns: 2000 };

  it('round trip: every frame comes back as it was', () => {
    fc.assert(
      fc.property(fc.integer({ min: 0, max: 255 }), fc.uint8Array({ maxLength: 252 }), (code, data) => {
        expect(new FrameDecoder().push(encodeFrame(code, data))).toEqual([{ code, data }]);
      }),
      runs,
    );
  });

  it('any split: the same frames whatever the chunks', () => {
    fc.assert(
      fc.property(stream, sizes, (bytes, pieces) => {
        expect(shown(decode(cut(bytes, pieces)))).toEqual(shown(decode([bytes])));
      }),
      runs,
    );
  });

  it('resynchronisation: exactly the frames of the law, whatever is around them', () => {
    fc.assert(
      fc.property(stream, sizes, (bytes, pieces) => {
        expect(shown(decode(cut(bytes, pieces)))).toEqual(shown(reference(bytes)));
      }),
      runs,
    );
  });

  it('every byte is told of once: as part of a frame or as passed over', () => {
    fc.assert(
      fc.property(stream, sizes, (bytes, pieces) => {
        const told: Uint8Array[] = [];
        const decoder = new FrameDecoder({
          onFrame: (_, wire) => told.push(wire),
          onRejected: (rejection) => told.push(rejection.bytes),
        });
        decode(cut(bytes, pieces), decoder);
        // Runs of more than five zeros are shown as five, and zeros at the very end still wait for what follows.
        const plain = (all: Uint8Array): string =>
          toHex(all)
            .replaceAll(/(00 ?){5,}/g, '00 00 00 00 00 ')
            .replace(/(00 ?)+$/, '')
            .trim();
        expect(plain(concat(...told))).toBe(plain(bytes));
      }),
      runs,
    );
  });
});
