/**
 * Calls a function of the caller. An error that it throws is reported like an uncaught one and does not disturb the
 * work here.
 * @returns what the function gave; undefined when there is none, or when it threw.
 */
export function tell<Args extends readonly unknown[], Result>(
  callback: ((...args: Args) => Result) | undefined,
  ...args: Args
): Result | undefined {
  try {
    return callback?.(...args);
  } catch (error) {
    report(error);
    return undefined;
  }
}

function report(error: unknown): void {
  // Node does not have it.
  if (typeof globalThis.reportError === 'function') globalThis.reportError(error);
  else {
    queueMicrotask(() => {
      throw error;
    });
  }
}
