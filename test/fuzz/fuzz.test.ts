import { describe, expect, it } from 'vitest';
import * as program from '../../src/program/index.js';
import * as protocol from '../../src/protocol/index.js';
import { type Frame, FrameDecoder } from '../../src/protocol/index.js';
import { fuzz } from './fuzz.js';
import { KEPT_LAWS } from './kept-laws.js';
import { LAWS } from './laws.js';

const once = (round: number): boolean => round < 1;

describe('the fuzzer', () => {
  it('finds nothing in streams, files and links in a thousand cases', () => {
    const laws = { ...LAWS, ...KEPT_LAWS };
    expect(fuzz({ ...protocol, ...program }, { seed: 20130219, cases: 60, more: once, laws })).toEqual({
      cases: 60 * Object.keys(laws).length,
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
