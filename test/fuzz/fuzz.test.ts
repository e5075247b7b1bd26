import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import * as protocol from '../../src/protocol/index.js';
import { type Bytes, type Frame, FrameDecoder, type FrameDecoderOptions } from '../../src/protocol/index.js';
import { fuzz } from './fuzz.js';
import { LAWS, type Protocol } from './laws.js';

const once = (round: number): boolean => round < 1;

describe('the fuzzer', () => {
  it('finds nothing in a few thousand cases', () => {
    expect(fuzz(protocol, { seed: 20130219, cases: 300, more: once })).toEqual({
      cases: 300 * Object.keys(LAWS).length,
      failure: null,
    });
  });

  it('names a seed that finds the same again, and the bytes', () => {
    const found = fuzz({ ...protocol, FrameDecoder: Forgetful }, { seed: 1, cases: 20, more: () => true }).failure;
    expect(found).toMatchObject({ law: expect.stringContaining('any split') });
    expect(found?.report).toMatch(/\n {2}frame: 00 00 00 00 (00 )?03 .. .. 45\n/);
    expect(
      fuzz({ ...protocol, FrameDecoder: Forgetful }, { seed: found?.seed ?? 0, cases: 20, more: once }).failure,
    ).toEqual(found);
  });
});

/** Knows nothing of earlier pieces. */
class Forgetful extends FrameDecoder {
  override push(chunk: Uint8Array): Frame[] {
    return new FrameDecoder().push(chunk);
  }
}

/** Skips a candidate that was refused with all the bytes it had asked for. */
class Trusting extends FrameDecoder {
  override push(chunk: Uint8Array): Frame[] {
    const frames = super.push(chunk);
    const header = chunk.findIndex(
      (byte, at) => at >= 4 && byte > 0 && chunk.subarray(at - 4, at).every((b) => b === 0),
    );
    const frame = frames[0];
    return frame && frame.data.length + 3 === chunk[header] ? frames : frames.slice(1);
  }
}

/** Does not know silence. */
class Patient extends FrameDecoder {
  override idle(): Frame[] {
    return [];
  }
}

/** Keeps what it has passed over to itself when it is one byte. */
class Discreet extends FrameDecoder {
  constructor({ onRejected, ...options }: FrameDecoderOptions = {}) {
    super({ ...options, onRejected: (rejection) => rejection.bytes.length > 1 && onRejected?.(rejection) });
  }
}

/** Takes bare checksums that nobody asked for. */
class Generous extends FrameDecoder {
  constructor(options: FrameDecoderOptions = {}) {
    super({ ...options, quirks: { bareChecksum: Array.from({ length: 256 }, (_, letter) => letter) } });
  }
}

/** Keeps everything until the line is silent. */
class Hoarder extends FrameDecoder {
  #all: number[] = [];
  override push(chunk: Uint8Array): Frame[] {
    this.#all.push(...chunk);
    return [];
  }
  override idle(): Frame[] {
    const frames = super.push(Uint8Array.from(this.#all));
    this.#all = [];
    return [...frames, ...super.idle()];
  }
}

/** Gives out its caller's bytes. */
class Lender extends FrameDecoder {
  override push(chunk: Uint8Array): Frame[] {
    return super.push(chunk).map((frame) => {
      const at = Buffer.from(chunk).indexOf(frame.data);
      const lent = chunk.subarray(at, at + frame.data.length) as Bytes;
      return at < 0 || frame.data.length === 0 ? frame : { ...frame, data: lent };
    });
  }
}

describe('each law notices what breaks it', () => {
  const faults: [law: string, broken: Partial<Protocol>][] = [
    ['round trip: a frame', { encodeFrame: (code, data) => protocol.encodeFrame(code, data, { bareChecksum: true }) }],
    ['round trip: a message', { encodeRequest: (request) => protocol.encodeRequest(request) }],
    [
      'round trip: bytes',
      {
        decodeReply: (frame, options) =>
          protocol.decodeReply({ ...frame, data: frame.data.slice().reverse() }, options),
      },
    ],
    ['any split', { FrameDecoder: Forgetful }],
    ['resynchronisation', { FrameDecoder: Trusting }],
    ['silence', { FrameDecoder: Patient }],
    ['every byte', { FrameDecoder: Discreet }],
    ['never throws', { FrameDecoder: Generous }],
    ['holds', { FrameDecoder: Hoarder }],
    ['frames own', { FrameDecoder: Lender }],
  ];

  it.each(faults)('%s', (law, broken) => {
    const [[, property] = []] = Object.entries(LAWS).filter(([name]) => name.startsWith(law));
    expect(
      property && fc.check(property({ ...protocol, ...broken }), { seed: 1, numRuns: 3000, endOnFailure: true }),
    ).toMatchObject({
      failed: true,
    });
  });

  it('all of them', () => expect(faults).toHaveLength(Object.keys(LAWS).length));
});
