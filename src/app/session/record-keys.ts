import type { TimerProgram } from '../../program/index.js';
import type { Identity } from '../../protocol/index.js';

/** The kind of a timer: nothing tells one timer from another of its kind. */
export function kindKey({ timerClass, firmware, functions, servos }: Identity, simulated: boolean): string {
  return [simulated ? 'simulated' : 'timer', timerClass, firmware, functions, servos].join('/');
}

/** As much of an identity as a key of {@link kindKey} tells; null when it is none. */
export function identityOfKind(key: string): Pick<Identity, 'timerClass' | 'firmware'> | null {
  const [, timerClass, firmware] = /^[a-z]+\/(.)\/([^/]*)\//.exec(key) ?? [];
  return timerClass === undefined || firmware === undefined ? null : { timerClass, firmware };
}

/** What a program is for: kind of timer and memory. */
export function programKey(
  { identity, memory }: Pick<TimerProgram, 'identity' | 'memory'>,
  simulated: boolean,
): string {
  return `${kindKey(identity, simulated)}/${memory ?? '?'}`;
}

/**
 * Under what the work on a program is kept: each tab, by its number, has its own, see `TabNumber`.
 * @param madeAt of a program that was read from no timer: each of them is kept by itself.
 */
export function workKey(program: TimerProgram, simulated: boolean, tab: number, madeAt?: number): string {
  const key = madeAt === undefined ? programKey(program, simulated) : `made/${madeAt}`;
  // The first is called as those were that had no number.
  return tab > 1 ? `${key}/${tab}` : key;
}
