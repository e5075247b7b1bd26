import type { MemoryContent } from './memory.js';

/** One setting of a model, as a pilot notes it: columns from launch to DT. */
interface ExampleSetting {
  /** Times of functions 1 to 9, then DT, in hundredths of a second from launch. */
  readonly times: readonly number[];
  /** Motor stop in hundredths of a second. Class Q only. */
  readonly motorStop?: number;
  /** Steps at start, functions 1 to 9, DT. */
  readonly rudder: readonly number[];
  /** More steps turn the tailplane up: the climb, the bunt after it, the glide, and fully up at DT. */
  readonly tailplane: readonly number[];
  readonly wing: readonly number[];
}

/** An F1Q: climb, small corrections before and after motor stop, a bunt into the glide. */
const Q_CALM: ExampleSetting = {
  motorStop: 1000,
  times: [30, 120, 400, 980, 1010, 1060, 1120, 1250, 2000, 18000],
  rudder: [62, 62, 64, 64, 66, 70, 70, 67, 65, 63, 63],
  tailplane: [48, 44, 46, 50, 52, 30, 24, 40, 54, 56, 95],
  wing: [70, 70, 72, 76, 78, 78, 82, 86, 88, 88, 88],
};

/** For wind: a slightly shorter climb and tighter circles. */
const Q_WIND: ExampleSetting = {
  ...Q_CALM,
  motorStop: 950,
  times: [30, 120, 400, 930, 960, 1010, 1070, 1200, 1800, 18000],
  rudder: [60, 60, 63, 64, 67, 72, 74, 72, 71, 70, 70],
  tailplane: [46, 42, 44, 48, 50, 28, 22, 38, 52, 53, 95],
};

/** A few seconds of motor and an early DT, to watch the transition near the ground. */
const Q_TEST: ExampleSetting = {
  ...Q_CALM,
  motorStop: 400,
  times: [30, 120, 250, 380, 410, 460, 520, 650, 1000, 2000],
};

/** The long flight that decides a contest, with less energy for the climb. */
const Q_FLY_OFF: ExampleSetting = {
  ...Q_CALM,
  motorStop: 800,
  times: [30, 120, 400, 780, 810, 860, 920, 1050, 1800, 48000],
  tailplane: [48, 44, 46, 50, 52, 30, 24, 40, 55, 57, 95],
  wing: [70, 70, 72, 76, 78, 78, 82, 88, 90, 90, 90],
};

/** An F1B: burst, climb and cruise of the rubber motor, then the glide. The last function repeats the one before it. */
const B_CALM: ExampleSetting = {
  times: [12, 65, 150, 500, 1200, 2500, 3800, 4000, 4500, 18000],
  rudder: [70, 72, 68, 66, 66, 65, 64, 60, 58, 58, 58],
  tailplane: [40, 36, 42, 46, 48, 50, 52, 55, 57, 57, 100],
  wing: [60, 60, 64, 68, 70, 72, 74, 80, 80, 80, 80],
};

const B_WIND: ExampleSetting = {
  ...B_CALM,
  times: [10, 55, 130, 450, 1000, 2200, 3400, 3600, 4100, 18000],
  rudder: [68, 70, 66, 65, 66, 66, 66, 65, 64, 64, 64],
  tailplane: [40, 36, 41, 44, 46, 48, 50, 53, 54, 54, 100],
};

/** For a flight with few turns on the rubber motor. */
const B_TEST: ExampleSetting = {
  ...B_CALM,
  times: [12, 65, 150, 300, 500, 700, 900, 1100, 1400, 2000],
};

const B_FLY_OFF: ExampleSetting = {
  ...B_CALM,
  times: [12, 65, 150, 500, 1200, 2600, 4200, 4400, 4900, 36000],
  tailplane: [40, 36, 42, 46, 48, 50, 52, 56, 58, 58, 100],
  wing: [60, 60, 64, 68, 70, 72, 74, 82, 82, 82, 82],
};

/**
 * An F1E: a magnet steers it along the slope. The timer frees it, lets it circle, and brings it down. Functions that
 * are not needed repeat the one before, and there is no servo at S3.
 */
const E_CALM: ExampleSetting = {
  times: [300, 6000, 6500, 7000, 7500, 8000, 8500, 9000, 9500, 24000],
  rudder: [65, 65, 78, 78, 78, 78, 78, 78, 78, 78, 78],
  tailplane: [52, 55, 55, 55, 55, 55, 55, 55, 55, 55, 110],
  wing: Array.from({ length: 11 }, () => 65),
};

/** For wind: it flies straight out for longer, and faster. */
const E_WIND: ExampleSetting = {
  ...E_CALM,
  times: [300, 9000, 9500, 10000, 10500, 11000, 11500, 12000, 12500, 18000],
  tailplane: [48, 50, 50, 50, 50, 50, 50, 50, 50, 50, 110],
};

const E_TEST: ExampleSetting = {
  ...E_CALM,
  times: [300, 800, 900, 1000, 1100, 1200, 1300, 1400, 1500, 2000],
};

const E_FLY_OFF: ExampleSetting = {
  ...E_CALM,
  times: [300, 12000, 12500, 13000, 13500, 14000, 14500, 15000, 15500, 30000],
  tailplane: [52, 56, 56, 56, 56, 56, 56, 56, 56, 56, 110],
};

const SETTINGS = {
  Q: [Q_CALM, Q_WIND, Q_TEST, Q_FLY_OFF],
  B: [B_CALM, B_WIND, B_TEST, B_FLY_OFF],
  E: [E_CALM, E_WIND, E_TEST, E_FLY_OFF],
} as const;

/**
 * Four memories as a timer in use may hold them: trimmed for calm air, for wind, for a test flight with a DT of 20 s,
 * and for a fly-off. For the usual layout of 10 functions and 3 servos: S1 rudder, S2 tailplane, S3 wing. The values
 * are invented, after the manuals and what pilots tell. They belong to no real model.
 * @example
 * ```ts
 * import { exampleMemories, VirtualTimer } from 'sidus-timer/simulator';
 *
 * const timer = new VirtualTimer({ identity: { timerClass: 'Q' }, memories: exampleMemories('Q') });
 * console.log(timer.core.content.times[10]); // 18000
 * ```
 */
export function exampleMemories(timerClass: 'Q' | 'B' | 'E'): MemoryContent[] {
  return SETTINGS[timerClass].map(({ motorStop = 0, times, rudder, tailplane, wing }) => ({
    times: [motorStop, ...times],
    positions: [[...rudder], [...tailplane], [...wing]],
  }));
}
