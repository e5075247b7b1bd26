import type { ReadErrorKind } from './types.js';

const READ_ERRORS: Record<ReadErrorKind, readonly [name: string, message: string]> = {
  break: ['BreakError', 'A break was received.'],
  framing: ['FramingError', 'A framing error was received.'],
  parity: ['ParityError', 'A parity error was received.'],
  overrun: ['BufferOverrunError', 'The receive buffer overran.'],
  system: ['UnknownError', 'An unknown system error has occurred.'],
  lost: ['NetworkError', 'The device has been lost.'],
};

export const READ_ERROR_KINDS: readonly string[] = Object.keys(READ_ERRORS);

/** The exception for a kind of failure, as the standard's readable and writable attributes name it. */
export function streamError(kind: ReadErrorKind): DOMException {
  const [name, message] = READ_ERRORS[kind];
  return new DOMException(message, name);
}

export function invalidState(message: string): DOMException {
  return new DOMException(message, 'InvalidStateError');
}

export function networkError(message: string): DOMException {
  return new DOMException(message, 'NetworkError');
}
