import { effect, type ReadonlySignal, signal } from '@preact/signals';
import type { LinkState } from '../../serial/index.js';

const ASKING: ReadonlySet<LinkState['status']> = new Set(['searching', 'waiting']);

/**
 * How long a timer has been asked without an answer: whole seconds since the first question; 0 while no timer is asked.
 */
export function secondsAsked(state: ReadonlySignal<LinkState>): ReadonlySignal<number> {
  const seconds = signal(0, { name: 'waitedSeconds' });
  let asking = false;
  let next: ReturnType<typeof setTimeout> | undefined;
  effect(() => {
    const isAsking = ASKING.has(state.value.status);
    if (isAsking === asking) return;
    asking = isAsking;
    clearTimeout(next);
    seconds.value = 0;
    if (!asking) return;
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
