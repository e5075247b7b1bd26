import { describe, expect, it } from 'vitest';
import { type DecoderQuirks, encodeFrame, type Frame, FrameDecoder, type Rejection } from '../../src/protocol/index.js';
import { concat, cut, fromHex, toHex } from '../tools/bytes.js';
import { PageDecoder } from './reference.js';
import { table } from './table.js';
import { CAPTURE, CAPTURE_PIECES } from './vectors.js';

function shown(frames: readonly Frame<Uint8Array>[]): string[] {
  return frames.map(({ code, data }) => toHex(concat(Uint8Array.of(code), data)));
}

function decode(pieces: readonly Uint8Array[], decoder = new FrameDecoder()): Frame[] {
  return [...pieces.flatMap((piece) => decoder.push(piece)), ...decoder.idle()];
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

  it('need four zeros, and may have more', () => {
    const rest = fromHex('03 6b 6b 45');
    for (const zeros of [0, 1, 2, 3]) expect(decode([concat(new Uint8Array(zeros), rest)])).toEqual([]);
    for (const zeros of [4, 5, 6, 1000]) expect(decode([concat(new Uint8Array(zeros), rest)])).toHaveLength(1);
  });

  it('may carry 45 and zeros inside', () => {
    expect(shown(decode([fromHex('00 00 00 00 00 09 62 45 00 00 00 00 00 a7 45')]))).toEqual(['62 45 00 00 00 00 00']);
  });

  it('are found after the rest of a held frame, however much comes with it', () => {
    const long = encodeFrame(0x62, new Uint8Array(252).fill(7));
    const short = encodeFrame(0x6b);
    const decoder = new FrameDecoder();
    decoder.push(long.subarray(0, -6));
    expect(decoder.push(concat(long.subarray(-6), ...Array<Uint8Array>(100).fill(short)))).toHaveLength(101);
  });

  it('are read from a Buffer of Node, whose slice is a view', () => {
    const pooled = Buffer.from([...encodeFrame(0x72, [3, 4, 5]), ...encodeFrame(0x76, [6, 7, 8])]);
    const frames = new FrameDecoder().push(pooled);
    pooled.fill(9);
    expect(frames).toEqual([
      { code: 0x72, data: Uint8Array.of(3, 4, 5) },
      { code: 0x76, data: Uint8Array.of(6, 7, 8) },
    ]);
  });
});

describe('frames that are not whole', () => {
  it('wait, and are dropped when the line falls silent', () => {
    const rejected: Rejection[] = [];
    const decoder = new FrameDecoder({ onRejected: (rejection) => rejected.push(rejection) });
    expect(decoder.push(fromHex('00 00 00 00 00 24 68 0f'))).toEqual([]);
    expect(decoder.waiting).toBe(true);
    expect(rejected).toEqual([]);
    expect(decoder.idle()).toEqual([]);
    expect(decoder.waiting).toBe(false);
    expect(rejected).toEqual([{ reason: 'silence', bytes: fromHex('00 00 00 00 00 24 68 0f') }]);
  });

  it('may hide a real one, which is found when the line falls silent', () => {
    const decoder = new FrameDecoder();
    const hidden = encodeFrame(0x6c, fromHex('42 35 33 36 20 0a 04 03 20'));
    expect(decoder.push(concat(fromHex('00 00 00 00 24 68'), hidden))).toEqual([]);
    expect(shown(decoder.idle())).toEqual(['6c 42 35 33 36 20 0a 04 03 20']);
  });

  it('are not searched before that, because times can look like a frame', () => {
    const inner = encodeFrame(0x6b);
    const outer = encodeFrame(0x62, concat(Uint8Array.of(1), inner));
    const decoder = new FrameDecoder();
    expect(decoder.push(outer.subarray(0, outer.length - 1))).toEqual([]);
    expect(decoder.push(outer.subarray(outer.length - 1))).toEqual([
      { code: 0x62, data: concat(Uint8Array.of(1), inner) },
    ]);
  });
});

describe('headers inside held bytes', () => {
  it('find their frame although there is no room left for it', () => {
    const frame = encodeFrame(0x62, new Uint8Array(252).fill(7)).subarray(1);
    // Each false header asks for 255 bytes, the last of which is the header of the next one.
    const header = fromHex('00 00 00 00 ff');
    const inside = (length: number) => concat(new Uint8Array(length - header.length).fill(1), header);
    const bytes = concat(header, inside(250), inside(250), concat(new Uint8Array(245).fill(1), frame));
    for (const size of [1, 7, 100, bytes.length]) {
      const pieces = Array.from({ length: Math.ceil(bytes.length / size) }, (_, index) =>
        bytes.subarray(index * size, (index + 1) * size),
      );
      expect(shown(decode(pieces)), `the frame is found in pieces of ${size} bytes`).toHaveLength(1);
    }
  });

  it('get only the zeros that came', () => {
    const decoder = new FrameDecoder();
    const found = ['00 00 00 00 05', '01 01 00 00 00', '03 6b 6b 45'].map((piece) => decoder.push(fromHex(piece)));
    expect(found).toEqual([[], [], []]);
    // Three after a byte that is looked at, and one in the next piece.
    expect(decode(['01 00 00 00', '00 03 6b 6b 45'].map(fromHex))).toHaveLength(1);
  });

  it('are dropped when their length is less than that of a frame', () => {
    const decoder = new FrameDecoder();
    for (const length of ['01', '02']) {
      decoder.push(fromHex(`00 00 00 00 ${length}`));
      expect(decoder.waiting, length).toBe(false);
    }
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
  it('is accepted for 76 when asked for, and marked', () => {
    const told: boolean[] = [];
    const decoder = new FrameDecoder({ quirks: { bareChecksum: true }, onFrame: (_, __, isBare) => told.push(isBare) });
    expect(shown(decode([bare, encodeFrame(0x76, [0x1e])], decoder))).toEqual(['76 1e', '76 1e']);
    expect(told).toEqual([true, false]);
  });
  it('is refused for every other letter and length', () => {
    const decoder = new FrameDecoder({ quirks: { bareChecksum: true } });
    expect(decode([fromHex('00 00 00 00 00 04 72 01 72 45')], decoder)).toEqual([]);
    expect(decode([fromHex('00 00 00 00 00 05 76 01 01 76 45')], decoder)).toEqual([]);
    expect(decode([fromHex('00 00 00 00 00 05 76 01 76 02 45')], decoder)).toEqual([]);
    expect(decode([fromHex('00 00 00 00 00 04 76 01 75 45')], decoder)).toEqual([]);
  });
});

describe('the streams that are published for decoders in other languages', () => {
  const decoders = {
    'this decoder': (quirks: DecoderQuirks) => new FrameDecoder({ quirks }),
    'the program of the protocol page': () => new PageDecoder(),
  };
  for (const [who, make] of Object.entries(decoders)) {
    // The page's program knows no quirks.
    for (const { name, quirks, steps } of table.streams.filter(({ quirks }) => !quirks || who === 'this decoder')) {
      it(`${who}: ${name}`, () => {
        const decoder = make(quirks ?? {});
        const delivered = steps.map(({ push }) =>
          shown(push === undefined ? decoder.idle() : decoder.push(fromHex(push))),
        );
        expect(delivered).toEqual(steps.map(({ frames }) => frames));
      });
    }
  }

  it('name every reason to refuse bytes', () => {
    const reasons = new Set<string>();
    const decoder = new FrameDecoder({ onRejected: ({ reason }) => reasons.add(reason) });
    for (const { steps } of table.streams)
      for (const { push } of steps) push ? decoder.push(fromHex(push)) : decoder.idle();
    expect(reasons).toEqual(new Set(['noise', 'length', 'terminator', 'checksum', 'silence']));
  });
});
