import { EVENTS } from './events.js';
import { FACE } from './face.js';
import type { Probe } from './lab.js';
import { LOSS } from './loss.js';
import { OPEN } from './open.js';
import { READ } from './read.js';
import { REQUEST, UNTOUCHED } from './request.js';
import { WRITE } from './write.js';

/** One list for the mock port and a browser. */
export const PROBES: Readonly<Record<string, readonly Probe[]>> = {
  'the face of Serial and SerialPort': FACE,
  events: EVENTS,
  'requestPort() that nobody has clicked for': UNTOUCHED,
  'requestPort() after a click': REQUEST,
  'open(), close() and signals': OPEN,
  readable: READ,
  writable: WRITE,
  'a device that goes and comes': LOSS,
};

/** The subjects whose page has just been clicked. */
export const TOUCHED: readonly string[] = ['requestPort() after a click'];
