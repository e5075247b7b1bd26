import { CodecError } from '../../src/protocol/index.js';

/** What a call gives; when it is refused: the code, place, words and figures of its error. */
export function refusalOf(work: () => unknown): unknown {
  try {
    return work();
  } catch (error) {
    if (error instanceof CodecError) return [error.code, error.field, error.message, error.details];
    throw error;
  }
}
