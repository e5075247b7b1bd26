import type { TimerProgram } from '../../program/index.js';

/**
 * A flight that pilots recognise: climb, bunt, glide, DT. Drawn while this device keeps nothing else.
 * It is never written.
 */
export const EXAMPLE: TimerProgram = {
  identity: { timerClass: 'Q', firmware: '000', functions: 10, memories: 1, servos: 3 },
  memory: null,
  times: [1000, 30, 120, 400, 980, 1010, 1060, 1120, 1250, 2000, 18000],
  positions: [
    [62, 62, 64, 64, 66, 70, 70, 67, 65, 63, 63],
    [48, 44, 46, 50, 52, 30, 24, 40, 54, 56, 95],
    [70, 70, 72, 76, 78, 78, 82, 86, 88, 88, 88],
  ],
  idleThrottle: null,
};
