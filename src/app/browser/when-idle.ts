/**
 * Does it once the browser has nothing else to do, after so many milliseconds at the latest.
 * @returns what takes it back.
 */
export function whenIdle(act: () => void, within: number): () => void {
  // Safari knows nothing of being idle.
  if (typeof requestIdleCallback !== 'function') {
    const timer = setTimeout(act, within);
    return () => clearTimeout(timer);
  }
  const id = requestIdleCallback(act, { timeout: within });
  return () => cancelIdleCallback(id);
}
