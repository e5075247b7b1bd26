import { CodecError } from '../../src/protocol/index.js';

/**
 * What a call gives; when it is refused: the code and the words of its error, the place before them where they do not
 * begin with it, and its figures. What was wanted is part of the words.
 */
export function refusalOf(work: () => unknown): unknown {
  try {
    return work();
  } catch (error) {
    if (!(error instanceof CodecError)) throw error;
    const { code, field, message } = error;
    const { wanted, ...details } = error.details;
    if (wanted !== undefined && !message.includes(` ${wanted}`)) return `“${message}” and not ${wanted}`;
    return [message.startsWith(`${field} `) ? `${code} ${message}` : `${code} ${field}: ${message}`, details];
  }
}
