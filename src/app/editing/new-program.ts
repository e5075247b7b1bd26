import type { TimerProgram } from '../../program/index.js';
import { type Identity, slotCount } from '../../protocol/index.js';

/** The classes for which a program can be made. */
export const CLASSES = ['Q', 'B', 'E'] as const;
type NewClass = (typeof CLASSES)[number];

/** What the new program is for, and how it begins. */
export interface NewProgram {
  readonly timerClass: NewClass;
  /** NF, as in an identity: the functions and DT. */
  readonly functions: number;
  readonly servos: number;
  /** `usual`: usual times of the class, and all servos in the middle. `nothing`: all values are 0. */
  readonly from: 'usual' | 'nothing';
}

/** The layout of most timers: nine functions and DT, three servos. */
export const USUAL_LAYOUT = { functions: 10, servos: 3 } as const;
/** The smallest and the largest number that can be chosen. */
export const LAYOUTS = { functions: [2, 20], servos: [1, 8] } as const;

/** Half of 130 steps. Only the pilot knows where a surface then stands. */
const MIDDLE = 65;

/**
 * Times of a usual flight, in hundredths of a second: slot 0, the functions, DT. The functions of Q lie around a motor
 * stop at 10 s, those of B around the unwinding of the motor, those of E over a slope flight.
 */
const USUAL: Readonly<Record<NewClass, { start: number; functions: readonly number[]; dt: number }>> = {
  Q: { start: 1000, functions: [30, 100, 300, 600, 970, 1000, 1030, 1100, 1250], dt: 18000 },
  B: { start: 0, functions: [10, 50, 150, 400, 1000, 2000, 3500, 3700, 4000], dt: 18000 },
  E: { start: 0, functions: [100, 200, 500, 1000, 2000, 4000, 6000, 9000, 12000], dt: 30000 },
};
/** The distance of functions beyond the usual ones, in hundredths of a second. */
const FURTHER = 100;

/** A program that was read from no timer, so its firmware and memory are not known. */
export function newProgram({ timerClass, functions, servos, from }: NewProgram): TimerProgram {
  const identity: Identity = { timerClass, firmware: '000', functions, memories: 1, servos };
  const slots = slotCount(identity);
  const usual = from === 'usual';
  const times = usual ? usualTimes(timerClass, functions) : Array.from({ length: slots }, () => 0);
  const row = Array.from({ length: slots }, () => (usual ? MIDDLE : 0));
  return {
    identity,
    memory: null,
    times,
    positions: Array.from({ length: servos }, () => [...row]),
    idleThrottle: null,
  };
}

function usualTimes(timerClass: NewClass, functions: number): number[] {
  const { start, functions: usual, dt } = USUAL[timerClass];
  const last = usual.at(-1) as number;
  const between = Array.from(
    { length: functions - 1 },
    (_, at) => usual[at] ?? last + FURTHER * (at - usual.length + 1),
  );
  return [start, ...between, dt];
}
