/**
 * Calls a consumer's function. What it throws is reported as an uncaught error is, and does not disturb what is under
 * way here.
 * @returns what the function gave; undefined when there is none, or it threw.
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
  // Node has none.
  if (typeof globalThis.reportError === 'function') globalThis.reportError(error);
  else {
    queueMicrotask(() => {
      throw error;
    });
  }
}
