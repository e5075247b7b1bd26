import type { Bytes, Clock } from '../line/index.js';

/** What tells one port from another: the standard's SerialPortInfo dictionary. Members that do not apply are absent. */
export interface PortInfo {
  /** 0 to 0xFFFF. */
  readonly usbVendorId?: number | undefined;
  /** 0 to 0xFFFF. */
  readonly usbProductId?: number | undefined;
  /**
   * A UUID in lower case, or the 16- or 32-bit number that stands for it, such as 0x1101 for the Serial Port Profile.
   */
  readonly bluetoothServiceClassId?: number | string | undefined;
}

/** The standard's SerialPortFilter dictionary. A vendor, a vendor and a product, or a Bluetooth service class. */
export type PortFilter = PortInfo;

/** The standard's SerialPortRequestOptions dictionary. */
export interface PortRequestOptions {
  /** The chooser offers ports that match any of them. Absent or empty: all ports. */
  readonly filters?: readonly PortFilter[] | undefined;
  /** Service classes whose Bluetooth ports may be offered, besides the Serial Port Profile. */
  readonly allowedBluetoothServiceClassIds?: readonly (number | string)[] | undefined;
}

/** The standard's SerialOptions dictionary. */
export interface OpenOptions {
  /** Bits a second, above 0. */
  readonly baudRate: number;
  /** Default 8. */
  readonly dataBits?: 7 | 8 | undefined;
  /** Default 1. */
  readonly stopBits?: 1 | 2 | undefined;
  /** Default `none`. */
  readonly parity?: 'none' | 'even' | 'odd' | undefined;
  /** The size of the port's buffer in each direction, 1 byte to 16 MiB. Default 255 bytes. */
  readonly bufferSize?: number | undefined;
  /** Default `none`. */
  readonly flowControl?: 'none' | 'hardware' | undefined;
}

/** The options with which a page opened a port, defaults filled in. */
export type OpenedOptions = { readonly [Key in keyof OpenOptions]-?: Exclude<OpenOptions[Key], undefined> };

/** What a page may set: the standard's SerialOutputSignals dictionary. */
export interface OutputSignals {
  /** The DTR line. */
  readonly dataTerminalReady?: boolean | undefined;
  /** The RTS line. */
  readonly requestToSend?: boolean | undefined;
  /** A break: the line is held at 0. */
  readonly break?: boolean | undefined;
}

/** What a page has set. */
export type SetSignals = { readonly [Key in keyof OutputSignals]-?: boolean };

/** What a page may ask for: the standard's SerialInputSignals dictionary. */
export interface InputSignals {
  /** The DCD line. */
  readonly dataCarrierDetect: boolean;
  /** The CTS line. */
  readonly clearToSend: boolean;
  /** The RI line. */
  readonly ringIndicator: boolean;
  /** The DSR line. */
  readonly dataSetReady: boolean;
}

/**
 * What can go wrong while a page reads, and the error of its `read()`:
 * - `break`: BreakError
 * - `framing`: FramingError
 * - `parity`: ParityError
 * - `overrun`: BufferOverrunError
 * - `system`: UnknownError, an error of the operating system
 * - `lost`: NetworkError, the only fatal one: `readable` is null until the port is closed and opened again
 */
export type ReadErrorKind = 'break' | 'framing' | 'parity' | 'overrun' | 'system' | 'lost';

/**
 * What can go wrong while a page writes, and the error of its `write()`:
 * - `system`: UnknownError, an error of the operating system
 * - `lost`: NetworkError, fatal: `writable` is null until the port is closed and opened again
 */
export type WriteErrorKind = 'system' | 'lost';

/**
 * What arrives in place of a byte: `[byte]` unchanged, `[]` lost.
 * `index` counts the bytes sent in that direction, from 0.
 */
export type Fault = (byte: number, index: number) => readonly number[];

/** What a mock port is like. Everything beyond the standard is off by default. */
export interface PlugOptions {
  /** The site may use the port already, as if the browser remembered it from an earlier visit. Default false. */
  readonly granted?: boolean;
  /** Another program holds the port: `open()` fails with NetworkError. Default false. */
  readonly busy?: boolean;
  /** Where time comes from. Default: the clock of the MockSerial. */
  readonly clock?: Clock;
  /**
   * Bytes take as long as they would at the rate with which the page opened the port. Default false: the line takes no
   * time and needs no clock.
   */
  readonly timing?: boolean;
  /** Milliseconds that a byte takes in either direction, beyond its time on the wire. Default 0. */
  readonly latency?: number;
  /**
   * How many bytes reach the page together. The sizes are used in turn, then again from the first. Default: as the
   * device wrote them.
   */
  readonly chunks?: readonly number[];
  /** Damage on the line. */
  readonly fault?: { readonly toDevice?: Fault; readonly toPage?: Fault };
}

/** How a `MockSerial` is made. */
export interface MockSerialOptions {
  /** The clock of all ports that are plugged in without a clock of their own. Default: the real clock. */
  readonly clock?: Clock;
  /** Whether `requestPort()` may ask the user. Default false, as in a page that nobody has touched. */
  readonly userActivation?: boolean;
  /** Ways of Chromium that differ from the standard: all (`true`), or some. Default: none. */
  readonly chromium?: boolean | ChromiumWays;
}

/** How a real Chromium was seen to differ from the standard. */
export interface ChromiumWays {
  /** The first write after an unplug resolves although no device is there; the next one rejects. */
  readonly firstLostWriteResolves?: boolean;
  /** Bytes that come while the buffer is full wait for room: there is no BufferOverrunError. */
  readonly bufferNeverOverruns?: boolean;
  /** A listener that was added to Serial with `{ once: true }` never hears the browser's own events. */
  readonly onceNeverFires?: boolean;
  /** After an unplug `writable` fails by itself once the first write is lost, without another write. */
  readonly lostWriteEndsStream?: boolean;
  /**
   * A `close()` that fails because `writable` is locked leaves a `readable` whose next touch kills the tab. Here it
   * throws an error that says so.
   */
  readonly failedCloseKills?: boolean;
  /** `readable` is null as soon as `close()` has begun. */
  readonly closingHidesReadable?: boolean;
  /** Bytes that follow a break in the same burst come before the BreakError. */
  readonly breakComesLast?: boolean;
  /** A port that was forgotten, granted and opened again has its old `readable`, with the bytes of before. */
  readonly forgottenStreamReturns?: boolean;
  /** `open()` raises RTS, too. */
  readonly openRaisesRts?: boolean;
}

/** Whether a port follows a way of Chromium. */
export type FollowsWay = (way: keyof ChromiumWays) => boolean;

/** The other end of a port, for a test or a simulator. */
export interface MockDevice {
  /** The options with which the page opened the port, defaults filled in; null while it is closed. */
  readonly opened: OpenedOptions | null;
  /** Called with `opened` each time the page opens or closes the port, or loses it by `forget()`. */
  onopenchange: ((opened: OpenedOptions | null) => void) | null;
  /** Another program holds the port: the page's next `open()` fails with NetworkError. */
  busy: boolean;
  /** The page's `setSignals()` and `getSignals()` fail with NetworkError while this is true. */
  failSignals: boolean;
  /**
   * The signals that the page has set. Opening raises DTR, and RTS under hardware flow control. Closing drops all.
   */
  readonly signals: SetSignals;
  /**
   * How many bytes were written here that the page will never see: the port was unplugged or closed, or its buffer
   * full, when they came. Under hardware flow control the device waits for room.
   */
  readonly lost: number;
  /**
   * Waits for the next bytes that the page wrote, and gives one chunk of them, no longer than the port's buffer. Reads
   * are served in the order of their calls, and no byte is lost between them. A read goes on waiting when the page
   * closes the port.
   * @returns an empty array once the port is unplugged and everything that had arrived is read.
   */
  read(): Promise<Bytes>;
  /**
   * Sends bytes to the page. `lost` counts those that arrive while the port is unplugged or closed.
   * @throws TypeError when they are no bytes.
   */
  write(bytes: ArrayLike<number>): void;
  /**
   * Lets a pair of streams answer here, such as a `VirtualTimer` of `sidus-timer/simulator`: it gets what the page
   * writes, also after the port was plugged in again, and the page gets what it sends. When its streams fail, the
   * device is silent. It reads, so call `read()` no more.
   */
  join(pair: { readonly readable: ReadableStream<Uint8Array>; readonly writable: WritableStream<Uint8Array> }): void;
  /**
   * Makes the page's reading fail, after all bytes written before; see `ReadErrorKind`.
   * Does nothing while the port is closed.
   * @throws TypeError when there is no such kind.
   */
  error(kind: ReadErrorKind): void;
  /**
   * Sets what the page gets from `getSignals()`. Signals that are left out keep their value. All are false at first.
   */
  setSignals(signals: Partial<InputSignals>): void;
  /**
   * Makes the page's next write, or its next `close()` or `abort()` of the writable, fail.
   * @param kind default `system`.
   * @throws TypeError when there is no such kind.
   */
  failNextWrite(kind?: WriteErrorKind): void;
}
