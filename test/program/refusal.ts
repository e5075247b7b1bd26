import { CodecError } from '../../src/protocol/index.js';

/**
 * What a call gives; when it is refused: the code, place, words and figures of its error. What was wanted is part of
 * the words.
 */
export function refusalOf(work: () => unknown): unknown {
  try {
    return work();
  } catch (error) {
    if (!(error instanceof CodecError)) throw error;
    const { wanted, ...details } = error.details;
    if (wanted !== undefined && !error.message.includes(` ${wanted}`)) return `“${error.message}” and not ${wanted}`;
    return [error.code, error.field, error.message, details];
  }
}
