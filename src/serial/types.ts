import type { BytePort } from '../client/index.js';

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
  getInfo(): {
    usbVendorId?: number | undefined;
    usbProductId?: number | undefined;
    bluetoothServiceClassId?: number | string | undefined;
  };
  addEventListener(type: 'connect' | 'disconnect', listener: (event: Event) => void): void;
  removeEventListener(type: 'connect' | 'disconnect', listener: (event: Event) => void): void;
}

/** As much of `navigator.serial` as is used here. */
export interface SerialLike {
  getPorts(): Promise<SerialPortLike[]>;
  requestPort(): Promise<SerialPortLike>;
}
