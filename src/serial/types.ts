import type { BytePort } from '../client/index.js';

/** What a port says about itself. Members that do not apply are absent. */
export interface PortInfo {
  /** 0 to 0xFFFF. */
  readonly usbVendorId?: number | undefined;
  /** 0 to 0xFFFF. */
  readonly usbProductId?: number | undefined;
  /** A UUID, or the 16- or 32-bit number that stands for it. */
  readonly bluetoothServiceClassId?: number | string | undefined;
}

/**
 * The part of Web Serial's `SerialPort` that this package uses, so that neither it nor its users need the types of a
 * browser's serial API. A real port, a mock and a polyfill all fit.
 */
export interface SerialPortLike extends BytePort {
  /** Absent in browsers before 2024. There only a failed `open()` shows that the port is gone. */
  readonly connected?: boolean;
  /** Opens the port. `baudRate` is in bits a second, `bufferSize` in bytes. Rejects when the port does not open. */
  open(options: {
    baudRate: number;
    dataBits?: 7 | 8;
    stopBits?: 1 | 2;
    parity?: 'none' | 'even' | 'odd';
    bufferSize?: number;
  }): Promise<void>;
  /** Closes the port. Rejects while one of its streams is locked. */
  close(): Promise<void>;
  /** Absent in browsers before 2022. There the pilot has to withdraw the permission in the browser's own settings. */
  forget?(): Promise<void>;
  /** Needed only where the settings set DTR or RTS. */
  setSignals?(signals: { dataTerminalReady?: boolean; requestToSend?: boolean }): Promise<void>;
  /** What the port says about itself. */
  getInfo(): PortInfo;
  /** Events of this port: it was plugged in, or unplugged. */
  addEventListener(type: 'connect' | 'disconnect', listener: (event: Event) => void): void;
  /** Takes a listener away. */
  removeEventListener(type: 'connect' | 'disconnect', listener: (event: Event) => void): void;
}

/** The part of `navigator.serial` that this package uses. */
export interface SerialLike {
  /** The ports that the page may use. */
  getPorts(): Promise<SerialPortLike[]>;
  /** Lets the user choose a port in the browser's own dialog. Rejects with a DOMException when none is chosen. */
  requestPort(): Promise<SerialPortLike>;
  /** Events of ports that come and go. They bubble up from the ports. */
  addEventListener?(type: 'connect' | 'disconnect', listener: (event: Event) => void): void;
  /** Takes a listener away. */
  removeEventListener?(type: 'connect' | 'disconnect', listener: (event: Event) => void): void;
}
