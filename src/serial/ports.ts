import type { PortInfo, SerialPortLike } from './types.js';

/**
 * What a pilot would call the adapter of a port, by the vendor of its USB chip: FTDI, Silicon Labs CP210x, WCH CH340,
 * Prolific PL2303. `usb`: another vendor. `bluetooth`: a Bluetooth serial port. `other`: a port that says nothing about
 * itself, such as one built into a computer.
 */
export type PortKind = 'ftdi' | 'cp210x' | 'ch340' | 'pl2303' | 'bluetooth' | 'usb' | 'other';

/** A port that the pilot has allowed, with its name. */
export interface KnownPort {
  /** The port itself, for `TimerLink.connect()`. */
  readonly port: SerialPortLike;
  /** By the vendor of its USB chip. */
  readonly kind: PortKind;
  /**
   * The name under which settings of a port are remembered: `usb:0403:6001` (vendor and product, four hexadecimal
   * digits each), `bluetooth:` and the service class, or `other`. Nothing in Web Serial tells two adapters of one kind
   * apart, so they share a name.
   */
  readonly key: string;
  /** What the port says about itself. */
  readonly info: PortInfo;
}

const VENDORS: ReadonlyMap<number, PortKind> = new Map([
  [0x0403, 'ftdi'],
  [0x10c4, 'cp210x'],
  [0x1a86, 'ch340'],
  [0x067b, 'pl2303'],
]);

function portKind({ usbVendorId, bluetoothServiceClassId }: PortInfo): PortKind {
  if (bluetoothServiceClassId !== undefined) return 'bluetooth';
  if (usbVendorId === undefined) return 'other';
  return VENDORS.get(usbVendorId) ?? 'usb';
}

/** See {@link KnownPort}. @param info what `getInfo()` of the port gives. */
export function portKey({ usbVendorId, usbProductId, bluetoothServiceClassId }: PortInfo): string {
  if (bluetoothServiceClassId !== undefined) return `bluetooth:${fullUuid(bluetoothServiceClassId)}`;
  if (usbVendorId === undefined) return 'other';
  return `usb:${hex(usbVendorId, 4)}:${hex(usbProductId ?? 0, 4)}`;
}

/** A port with its information, key and kind. */
export function known(port: SerialPortLike): KnownPort {
  const info = port.getInfo();
  return { port, kind: portKind(info), key: portKey(info), info };
}

/** Browsers give a service class as it was asked for: as a short number, or as the UUID that it stands for. */
function fullUuid(serviceClass: number | string): string {
  if (typeof serviceClass === 'string') return serviceClass.toLowerCase();
  return `${hex(serviceClass, 8)}-0000-1000-8000-00805f9b34fb`;
}

function hex(value: number, digits: number): string {
  return value.toString(16).padStart(digits, '0');
}
