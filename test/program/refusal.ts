import { CodecError } from '../../src/protocol/index.js';

/** What a call gives back; where it is refused, with which code, place, words and figures. */
export function refusalOf(work: () => unknown): unknown {
  try {
    return work();
  } catch (error) {
    if (error instanceof CodecError) return [error.code, error.field, error.message, error.details];
    throw error;
  }
}
