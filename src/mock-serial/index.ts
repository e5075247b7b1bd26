/**
 * A `navigator.serial` for tests, held to the Web Serial standard. It knows no timer.
 * @module
 */

export type { EventHandler } from './events.js';
export { MockSerialPort } from './port.js';
export { MockSerial } from './serial.js';
export type {
  ChromiumWays,
  Fault,
  InputSignals,
  MockDevice,
  MockSerialOptions,
  OpenedOptions,
  OpenOptions,
  OutputSignals,
  PlugOptions,
  PortFilter,
  PortInfo,
  PortRequestOptions,
  ReadErrorKind,
  SetSignals,
  WriteErrorKind,
} from './types.js';
