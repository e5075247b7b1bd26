import type { TimerProgram } from '../../src/program/index.js';

/** A program with these times, and positions that tell servo and column: 10, 11, 12 ... for S1, 20, 21 ... for S2. */
export function programOf(
  timerClass: string,
  timers: readonly number[],
  positions: readonly (readonly number[])[] = [1, 2, 3].map((servo) => timers.map((_, column) => servo * 10 + column)),
): TimerProgram {
  const identity = {
    timerClass,
    firmware: '536',
    functions: timers.length - 1,
    memories: 4,
    servos: positions.length,
  };
  return { identity, memory: 0, timers, positions, idleThrottle: null };
}
