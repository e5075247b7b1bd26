import type { TimerProgram } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';

/** The kind of a timer: nothing tells one timer from another of its kind. */
export function kindKey({ timerClass, firmware, functions, servos }: Identity, simulated: boolean): string {
  return [simulated ? 'simulated' : 'timer', timerClass, firmware, functions, servos].join('/');
}

/** Under what the work on a program is kept: kind of timer and memory. */
export function programKey({ identity, memory }: TimerProgram, simulated: boolean): string {
  return `${kindKey(identity, simulated)}/${memory ?? '?'}`;
}
