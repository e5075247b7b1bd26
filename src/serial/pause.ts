import type { Clock } from '../line/index.js';

/**
 * Settles after so many milliseconds, or at once when a signal asks to stop. Whoever waits looks at the signals then.
 */
export function pause(clock: Clock, ms: number, ...signals: readonly AbortSignal[]): Promise<void> {
  if (signals.some(({ aborted }) => aborted)) return Promise.resolve();
  return new Promise((resolve) => {
    const settle = (): void => {
      cancel();
      for (const signal of signals) signal.removeEventListener('abort', settle);
      resolve();
    };
    const cancel = clock.after(ms, settle);
    for (const signal of signals) signal.addEventListener('abort', settle);
  });
}
