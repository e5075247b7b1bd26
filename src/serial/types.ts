import type { BytePort } from '../client/index.js';

/** What a port says of itself. Members that do not apply are absent. */
export interface PortInfo {
  readonly usbVendorId?: number | undefined;
  readonly usbProductId?: number | undefined;
  /** A UUID, or the 16- or 32-bit number that stands for one. */
  readonly bluetoothServiceClassId?: number | string | undefined;
}

/**
 * As much of Web Serial's `SerialPort` as is used here, so that neither this package nor its users need the types of a
 * browser's serial API. A real port, a mock and a polyfill all fit.
 */
export interface SerialPortLike extends BytePort {
  /** Absent in browsers before 2024; then only a failed open tells. */
  readonly connected?: boolean;
  open(options: {
    baudRate: number;
    dataBits?: 7 | 8;
    stopBits?: 1 | 2;
    parity?: 'none' | 'even' | 'odd';
    bufferSize?: number;
  }): Promise<void>;
  close(): Promise<void>;
  /** Absent in browsers before 2022; then the pilot has to take back the permission in the browser's own settings. */
  forget?(): Promise<void>;
  /** Needed only where the settings say how DTR or RTS are to stand. */
  setSignals?(signals: { dataTerminalReady?: boolean; requestToSend?: boolean }): Promise<void>;
  getInfo(): PortInfo;
  addEventListener(type: 'connect' | 'disconnect', listener: (event: Event) => void): void;
  removeEventListener(type: 'connect' | 'disconnect', listener: (event: Event) => void): void;
}

/** As much of `navigator.serial` as is used here. */
export interface SerialLike {
  getPorts(): Promise<SerialPortLike[]>;
  requestPort(): Promise<SerialPortLike>;
  /** Hears of ports that come and go: the events of ports bubble up to here. */
  addEventListener?(type: 'connect' | 'disconnect', listener: (event: Event) => void): void;
  removeEventListener?(type: 'connect' | 'disconnect', listener: (event: Event) => void): void;
}
