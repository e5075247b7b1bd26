import { type Clock, realClock } from '../line/index.js';
import { ConnectionTarget } from './events.js';
import { convertRequestOptions, offered } from './filters.js';
import { Hardware } from './hardware.js';
import { MockSerialPort } from './port.js';
import type { ChromiumWays, MockSerialOptions, PlugOptions, PortInfo, PortRequestOptions } from './types.js';

/**
 * A `navigator.serial` without a browser: the Web Serial standard's `Serial`, and what a user and a workbench do to it:
 * plug, unplug, choose. Nothing is plugged in at first, the user has touched nothing, and the chooser is dismissed.
 *
 * @example
 * ```ts
 * import { MockSerial } from 'sidus-timer/mock-serial';
 *
 * const serial = new MockSerial();
 * const port = serial.plug({ usbVendorId: 0x0403, usbProductId: 0x6001 });
 * await port.open({ baudRate: 9600 });
 * port.device.write([1, 2, 3]);
 * const reader = port.readable?.getReader();
 * console.log((await reader?.read())?.value?.join()); // 1,2,3
 * ```
 */
export class MockSerial extends ConnectionTarget {
  /**
   * Whether `requestPort()` may ask the user, as just after a click. Stays as it is set: the standard does not use it
   * up.
   */
  userActivation: boolean;
  readonly #clock: Clock;
  readonly #ways: ChromiumWays;
  readonly #ports = new Map<MockSerialPort, Hardware>();
  #choice: MockSerialPort | null = null;

  constructor(options: MockSerialOptions = {}) {
    const ways = waysOf(options.chromium);
    super(null, ways.onceNeverFires);
    this.#ways = ways;
    this.#clock = options.clock ?? realClock;
    this.userActivation = options.userActivation ?? false;
  }

  /**
   * Plugs in a device at a port of its own. If the site may use it already, `connect` is fired, never before this call
   * has returned.
   * @throws TypeError when the information names something that is no Bluetooth service class.
   */
  plug(info: PortInfo = {}, options: PlugOptions = {}): MockSerialPort {
    const clock = options.clock ?? this.#clock;
    return this.#bring(new Hardware(info, { ...options, clock, ways: this.#ways }));
  }

  /**
   * Pulls the plug. What is under way in either direction is lost; what has arrived can still be read. Then, or at once
   * if the page waits, reading and writing fail with NetworkError; `disconnect` is fired if the site may use the port.
   * @throws TypeError when the port is not one of this object's.
   */
  unplug(port: MockSerialPort): void {
    const hardware = this.#hardware(port);
    if (!hardware.plugged) return;
    hardware.unplug();
    this.#announce('disconnect', port);
  }

  /**
   * Plugs a device in again, as a browser does that recognises it. A wired one comes back as another port, with the
   * same `device` and the same permission; the old port stays unplugged for good, and its `open()` fails with
   * NetworkError. A Bluetooth one comes back as the port it was; the page must close that before it can use it again.
   * For a device that the browser does not recognise, `plug` it with the same information.
   * @param options `samePort`: also a wired one comes back as the port it was. Default false.
   * @returns the port at which it is now.
   * @throws TypeError when the port is not one of this object's.
   */
  replug(port: MockSerialPort, { samePort = false }: { readonly samePort?: boolean } = {}): MockSerialPort {
    const hardware = this.#hardware(port);
    if (hardware.plugged) return port;
    if (!hardware.isBluetooth && !samePort) return this.#bring(hardware.again());
    hardware.replug();
    this.#announce('connect', port);
    return port;
  }

  /** What the user answers to the chooser from now on: a port, or null to dismiss it. */
  choose(port: MockSerialPort | null): void {
    this.#choice = port;
  }

  /**
   * The `getPorts()` method: the ports that are plugged in and that the site may use, in the order in which they came.
   * A Bluetooth port is known while it is off, too.
   */
  async getPorts(): Promise<MockSerialPort[]> {
    return [...this.#ports].filter(([, it]) => it.granted && (it.plugged || it.isBluetooth)).map(([port]) => port);
  }

  /**
   * The `requestPort()` method. The site may use the port that the user chooses.
   * @throws TypeError when the argument is of another type, such as filters that are no list.
   * @throws SecurityError without user activation.
   * @throws TypeError when a filter is empty, has a product without its vendor or USB numbers beside a Bluetooth
   *   service class, or when a service class is none.
   * @throws NotFoundError when the user dismisses the chooser, or when it would not offer the chosen port: because it
   *   is unplugged, matches no filter, or is one of a Bluetooth service class that the request does not allow.
   */
  async requestPort(options: PortRequestOptions = {}): Promise<MockSerialPort> {
    const converted = convertRequestOptions(options);
    if (!this.userActivation) {
      throw new DOMException('Must be handling a user gesture to show a permission request.', 'SecurityError');
    }
    const isOffered = offered(converted);
    await null;
    const port = this.#choice;
    const hardware = port && this.#ports.get(port);
    if (!hardware?.plugged || !isOffered(hardware.info)) {
      throw new DOMException('No port selected by the user.', 'NotFoundError');
    }
    hardware.granted = true;
    hardware.forgotten = false;
    return port as MockSerialPort;
  }

  #bring(hardware: Hardware): MockSerialPort {
    const port = new MockSerialPort(hardware, this);
    this.#ports.set(port, hardware);
    this.#announce('connect', port);
    return port;
  }

  #hardware(port: MockSerialPort): Hardware {
    const hardware = this.#ports.get(port);
    if (!hardware) throw new TypeError('The port was not plugged in here.');
    return hardware;
  }

  #announce(type: 'connect' | 'disconnect', port: MockSerialPort): void {
    if (!this.#hardware(port).granted) return;
    queueMicrotask(() => port.dispatchEvent(new Event(type, { bubbles: true })));
  }
}

function waysOf(chromium: boolean | ChromiumWays = false): ChromiumWays {
  if (typeof chromium === 'object') return chromium;
  return { firstLostWriteResolves: chromium, bufferNeverOverruns: chromium, onceNeverFires: chromium };
}
