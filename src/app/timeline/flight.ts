import type { ProgramField, TimerProgram } from '../../program/index.js';
import { drawable, RUN_OUT } from './scale.js';

/**
 * How a flight passes a slot. `held`: its positions stay until the next slot. `passed`: the next slot has the same
 * time. `back`: the next slot has an earlier time, and nobody knows what the timer then does.
 */
type Passing = 'held' | 'passed' | 'back';

/** One slot of a flight, in the order of the slots. Times are hundredths of a second from launch. */
export interface Stage {
  readonly slot: number;
  readonly from: number;
  /** The time of the next slot; null for DT, the last one. */
  readonly until: number | null;
  readonly passing: Passing;
}

/** Start, the functions and DT. Start counts as at launch, because the time of slot 0 has another meaning. */
export function stagesOf({ times }: TimerProgram): Stage[] {
  return times.map((time, slot) => {
    const from = slot === 0 ? 0 : drawable(time);
    const next = times[slot + 1];
    const until = next === undefined ? null : drawable(next);
    const passing = until === null || until > from ? 'held' : until === from ? 'passed' : 'back';
    return { slot, from, until, passing };
  });
}

/** When the motor stops, in hundredths of a second; null for any class but Q. */
export function motorStopOf({ identity, times }: TimerProgram): number | null {
  return identity.timerClass === 'Q' ? (times[0] ?? null) : null;
}

/** The time in the flight to which a field belongs. The positions of the start belong to launch. */
export function timeOf({ times }: TimerProgram, field: ProgramField): number {
  if (field.kind === 'idleThrottle' || (field.kind === 'position' && field.slot === 0)) return 0;
  return times[field.slot] ?? 0;
}

/** Every time at which something happens, without launch. */
export function marksOf(program: TimerProgram): number[] {
  const stop = motorStopOf(program);
  return (stop === null ? program.times.slice(1) : program.times).map(drawable);
}

/** The end of what is shown: a few seconds after the last event. */
export function flightEnd(program: TimerProgram): number {
  return Math.max(0, ...marksOf(program)) + RUN_OUT;
}

/**
 * The last slot whose time, with the times of all slots before it, has come. It is not certain where times fall and a
 * later slot has come before this one is over: nobody knows what the timer then does.
 */
export function reachedAt({ times }: TimerProgram, time: number): { readonly slot: number; readonly certain: boolean } {
  const missing = times.findIndex((at, slot) => slot > 0 && at > time);
  if (missing < 0) return { slot: times.length - 1, certain: true };
  return { slot: missing - 1, certain: times.every((at, slot) => slot <= missing || at > time) };
}

/** The slots that come after one time and up to another, in their order: slot 0 is the motor stop. */
export function eventsBetween(program: TimerProgram, after: number, upTo: number) {
  const first = motorStopOf(program) === null ? 1 : 0;
  return program.times
    .map((time, slot) => ({ slot, time }))
    .filter(({ slot, time }) => slot >= first && time > after && time <= upTo)
    .sort((a, b) => a.time - b.time);
}
