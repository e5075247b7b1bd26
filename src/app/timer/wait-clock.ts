import { effect, type ReadonlySignal, signal } from '@preact/signals';
import type { LinkState } from '../../serial/index.js';

/** What the link waits for. */
const WAITS: Readonly<Partial<Record<LinkState['status'], 'port' | 'timer'>>> = {
  opening: 'port',
  searching: 'timer',
  waiting: 'timer',
};

/**
 * How long the link waits for the port to open, or for a timer to answer: whole seconds since it was opened or since
 * the first question; 0 while it waits for neither.
 */
export function secondsWaited(state: ReadonlySignal<LinkState>): ReadonlySignal<number> {
  const seconds = signal(0, { name: 'waitedSeconds' });
  let waitsFor: 'port' | 'timer' | undefined;
  let next: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    const now = WAITS[state.value.status];
    if (now === waitsFor) return;
    waitsFor = now;
    clearTimeout(next);
    seconds.value = 0;
    if (!now) return;
    const since = performance.now();
    const tick = (): void => {
      const passed = performance.now() - since;
      seconds.value = Math.floor(passed / 1000);
      // A page that was asleep counts the time that has really passed.
      next = setTimeout(tick, 1000 - (passed % 1000));
    };
    tick();
  });
  return seconds;
}
