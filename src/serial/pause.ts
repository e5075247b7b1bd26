import type { Clock } from '../line/index.js';

/** Settles after `ms` milliseconds, or at once when a signal asks to stop. The caller then checks its signals. */
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
