import type { TimerProgram } from '../../src/program/index.js';

/** A program with these times. Its positions tell servo and slot: 10, 11, 12 ... for S1, 20, 21 ... for S2. */
export function programOf(
  timerClass: string,
  times: readonly number[],
  positions: readonly (readonly number[])[] = [1, 2, 3].map((servo) => times.map((_, slot) => servo * 10 + slot)),
): TimerProgram {
  const identity = {
    timerClass,
    firmware: '536',
    functions: times.length - 1,
    memories: 4,
    servos: positions.length,
  };
  return { identity, memory: 0, times, positions, idleThrottle: null };
}
