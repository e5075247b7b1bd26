/**
 * Calls `act` once the browser has nothing else to do, at the latest after `within` milliseconds.
 * @returns a function that cancels the call.
 */
export function whenIdle(act: () => void, within: number): () => void {
  // Safari does not have it.
  if (typeof requestIdleCallback !== 'function') {
    const timer = setTimeout(act, within);
    return () => clearTimeout(timer);
  }
  const id = requestIdleCallback(act, { timeout: within });
  return () => cancelIdleCallback(id);
}
