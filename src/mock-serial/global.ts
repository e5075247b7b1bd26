// For pages into which a test puts one classic script, as Playwright's `addInitScript` does. It gives the mock port and
// the clock that a test turns by hand under one global name. The build makes dist/lib/mock-serial.global.js from it.

import { VirtualClock } from '../line/index.js';
import { MockSerial, MockSerialPort } from './index.js';

const classes = { MockSerial, MockSerialPort, VirtualClock };

declare global {
  /** The mock port, in a page that has loaded `sidus-timer/mock-serial.global.js`. */
  var SidusMockSerial: typeof classes;
}

globalThis.SidusMockSerial = classes;
