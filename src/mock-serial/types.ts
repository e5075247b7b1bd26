import type { Clock } from '../line/index.js';

/**
 * What tells one port from another: the standard's SerialPortInfo dictionary. Members that do not apply are left out.
 */
export interface PortInfo {
  /** 0 to 0xFFFF. */
  readonly usbVendorId?: number | undefined;
  /** 0 to 0xFFFF. */
  readonly usbProductId?: number | undefined;
  /** A UUID in lower case, or the 16- or 32-bit number that stands for one, as 0x1101 for the Serial Port Profile. */
  readonly bluetoothServiceClassId?: number | string | undefined;
}

/** The standard's SerialPortFilter dictionary. A vendor, a vendor and a product, or a Bluetooth service class. */
export type PortFilter = PortInfo;

/** The standard's SerialPortRequestOptions dictionary. */
export interface PortRequestOptions {
  /** The chooser offers what matches any of them; everything if absent or empty. */
  readonly filters?: readonly PortFilter[] | undefined;
  /** The service classes, beside the Serial Port Profile, whose Bluetooth ports may be offered. */
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
  /** Bytes the port holds for the page in either direction, 1 to 16 MiB. Default 255. */
  readonly bufferSize?: number | undefined;
  /** Default `none`. */
  readonly flowControl?: 'none' | 'hardware' | undefined;
}

/** What a page opened a port with, defaults filled in. */
export type OpenedOptions = { readonly [Key in keyof OpenOptions]-?: Exclude<OpenOptions[Key], undefined> };

/** What a page may set: the standard's SerialOutputSignals dictionary. */
export interface OutputSignals {
  readonly dataTerminalReady?: boolean | undefined;
  readonly requestToSend?: boolean | undefined;
  readonly break?: boolean | undefined;
}

/** What a page has set. */
export type SetSignals = { readonly [Key in keyof OutputSignals]-?: boolean };

/** What a page may ask for: the standard's SerialInputSignals dictionary. */
export interface InputSignals {
  readonly dataCarrierDetect: boolean;
  readonly clearToSend: boolean;
  readonly ringIndicator: boolean;
  readonly dataSetReady: boolean;
}

/**
 * What can go wrong while a page reads, and what its `read()` then rejects with:
 *
 * - `break`: BreakError
 * - `framing`: FramingError
 * - `parity`: ParityError
 * - `overrun`: BufferOverrunError
 * - `system`: UnknownError, an error of the operating system
 * - `lost`: NetworkError; the only fatal one: `readable` is null from then on until the port is closed and opened again
 */
export type ReadErrorKind = 'break' | 'framing' | 'parity' | 'overrun' | 'system' | 'lost';

/**
 * What can go wrong while a page writes: `system` (UnknownError) and `lost` (NetworkError, fatal), or an error of one's
 * own.
 */
export type WriteErrorKind = 'system' | 'lost';

/**
 * What arrives in place of a byte: `[byte]` as it is, `[]` lost. `index` counts the bytes sent that way, from 0.
 */
export type Fault = (byte: number, index: number) => readonly number[];

/** What a mock port is like. Everything beyond the standard is off unless asked for. */
export interface PlugOptions {
  /** The site may use the port already, as if the browser remembered it from an earlier visit. Default false. */
  readonly granted?: boolean;
  /** Another program holds the port: `open()` fails with NetworkError. Default false. */
  readonly busy?: boolean;
  /** Where time comes from. Default: the clock of the MockSerial. */
  readonly clock?: Clock;
  /**
   * Bytes take the time they would take at the rate the page opened the port with. Default false: the line takes no
   * time and needs no clock, and what the page writes stays in the port's buffer until the device reads it.
   */
  readonly timing?: boolean;
  /** Milliseconds a byte is under way, in either direction, beside its time on the wire. Default 0. */
  readonly latency?: number;
  /**
   * Sizes of the pieces in which bytes reach the page, used in turn and again from the first. Default: as the device
   * wrote them.
   */
  readonly chunks?: readonly number[];
  /** Damage on the line. */
  readonly fault?: { readonly toDevice?: Fault; readonly toPage?: Fault };
  /**
   * The page hears what it says, as on a single wire shared by both directions; the device hears it too. Default false.
   */
  readonly echo?: boolean;
  /**
   * Nothing but wires at the end of the cable: what the page sends comes back, a break as a zero byte and a break, RTS
   * as CTS, DTR as DSR and DCD. The device hears nothing. Default false.
   */
  readonly loopback?: boolean;
  /**
   * The device waits while the page's buffer is full, where its bytes would otherwise be lost with BufferOverrunError.
   * Always so when the page opens the port with hardware flow control. Default false.
   */
  readonly backpressure?: boolean;
}

export interface MockSerialOptions {
  /** The clock of all ports that are not plugged in with one of their own. Default: the real clock. */
  readonly clock?: Clock;
  /** Whether `requestPort()` may ask the user. Default false, as in a page that nobody has touched. */
  readonly userActivation?: boolean;
  /** The ways of Chromium that are not the standard's: all of them, or some. Default: none. */
  readonly chromium?: boolean | ChromiumWays;
}

/** What a real Chromium was seen to do otherwise than the standard has it. */
export interface ChromiumWays {
  /** The first write after an unplug resolves, although nobody is there; the next one rejects. */
  readonly firstLostWriteResolves?: boolean;
  /** What comes while the buffer is full waits for room: there is no BufferOverrunError. */
  readonly bufferNeverOverruns?: boolean;
  /** A listener that was added to Serial with `{ once: true }` is never called. */
  readonly onceNeverFires?: boolean;
}

/** The other end of a port: what a test or a simulator sees and does there. */
export interface MockDevice {
  /** What the page has opened the port with, defaults filled in; null while it is closed. */
  readonly opened: OpenedOptions | null;
  /** Called with `opened` each time the page opens or closes the port, and when it loses it by forgetting. */
  onopenchange: ((opened: OpenedOptions | null) => void) | null;
  /** Another program holds the port: the page's next `open()` fails with NetworkError. */
  busy: boolean;
  /** The page's `setSignals()` and `getSignals()` fail with NetworkError while this is true. */
  failSignals: boolean;
  /**
   * What the page has set. Opening raises DTR (and RTS under hardware flow control, while there is room); closing drops
   * all.
   */
  readonly signals: SetSignals;
  /**
   * Bytes written here that the page will never see: the port was unplugged or closed, or its buffer full, when they
   * came; or they were held back and never got into it.
   */
  readonly lost: number;
  /**
   * The next bytes the page wrote, chunk by chunk, no chunk longer than the port's buffer; waits for them. Reads are
   * served in the order of their calls, and no byte is lost between them. Waits on when the page closes the port.
   * @returns an empty array once the port is unplugged and all that had arrived before is read.
   */
  read(): Promise<Uint8Array>;
  /**
   * Sends bytes to the page. Those that find the port unplugged or closed when they arrive are counted in `lost`.
   * @returns settles when all of them are in the buffer of the port; rejects with NetworkError when some were
   * discarded. Nobody has to wait for it.
   */
  write(bytes: ArrayLike<number>): Promise<void>;
  /**
   * Lets the page's reading fail, behind all bytes written before; see `ReadErrorKind`. Nothing happens while the port
   * is closed.
   */
  error(kind: ReadErrorKind): void;
  /** Sets what the page gets from `getSignals()`; what is left out stays. All are false at first. */
  setSignals(signals: Partial<InputSignals>): void;
  /**
   * Lets the page's writing fail.
   * @param error default `system`.
   * @param after how many more bytes get through first; default 0: the next write, `close()` or `abort()` of the
   * writable fails.
   */
  failNextWrite(error?: WriteErrorKind | Error, after?: number): void;
}
