import fc from 'fast-check';
import { describe, it } from 'vitest';
import * as protocol from '../../src/protocol/index.js';
import { LAWS } from '../fuzz/laws.js';

describe('laws of decoder and codecs, ten thousand runs each', () => {
  for (const [name, law] of Object.entries(LAWS)) {
    it(name, () => void fc.assert(law(protocol), { numRuns: 10_000 }), 60_000);
  }
});
