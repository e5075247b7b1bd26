import type { TimerProgram } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';

/** The kind of a timer. Nothing tells two timers of one kind apart. */
export function kindKey({ timerClass, firmware, functions, servos }: Identity, simulated: boolean): string {
  return [simulated ? 'simulated' : 'timer', timerClass, firmware, functions, servos].join('/');
}

/** The key of a program: kind of timer and memory. */
export function programKey(
  { identity, memory }: Pick<TimerProgram, 'identity' | 'memory'>,
  simulated: boolean,
): string {
  return `${kindKey(identity, simulated)}/${memory ?? '?'}`;
}

/**
 * The key of the work on a program.
 * @param madeAt for a program that was read from no timer: each has a key of its own.
 */
export function workKey(program: TimerProgram, simulated: boolean, madeAt?: number): string {
  return madeAt === undefined ? programKey(program, simulated) : `made/${madeAt}`;
}
