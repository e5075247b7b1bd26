import { type Clock, realClock } from '../line/index.js';
import { ConnectionTarget } from './events.js';
import { offered } from './filters.js';
import { Hardware } from './hardware.js';
import { MockSerialPort } from './port.js';
import type { MockSerialOptions, PlugOptions, PortInfo, PortRequestOptions } from './types.js';

/**
 * A `navigator.serial` without a browser: the Web Serial standard's `Serial`, and what a user and a workbench do to it:
 * plug, unplug, choose. Nothing is plugged in at first, the user has touched nothing, and the chooser is dismissed.
 *
 *     const serial = new MockSerial();
 *     const port = serial.plug({ usbVendorId: 0x0403, usbProductId: 0x6001 });
 *     await port.open({ baudRate: 9600 });
 *     port.device.write([1, 2, 3]);
 */
export class MockSerial extends ConnectionTarget {
  /**
   * Whether `requestPort()` may ask the user, as just after a click. Stays as it is set: the standard does not use it
   * up.
   */
  userActivation: boolean;
  readonly #clock: Clock;
  readonly #ports = new Map<MockSerialPort, Hardware>();
  #choice: MockSerialPort | null = null;

  constructor(options: MockSerialOptions = {}) {
    super(null);
    this.#clock = options.clock ?? realClock;
    this.userActivation = options.userActivation ?? false;
  }

  /**
   * Plugs in a device at a port of its own. If the site may use it already, `connect` is fired, never before this call
   * has returned.
   * @throws TypeError when the information names something that is no Bluetooth service class.
   */
  plug(info: PortInfo = {}, options: PlugOptions = {}): MockSerialPort {
    const hardware = new Hardware(info, { ...options, clock: options.clock ?? this.#clock });
    const port = new MockSerialPort(hardware, this);
    this.#ports.set(port, hardware);
    this.#announce('connect', port);
    return port;
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
   * Plugs a device in again at the port it had, as the browser does for a device it recognises; the page must close the
   * port before it can use it again. For a device that returns as a new object, `plug` it with the same information
   * and, if the permission is remembered, `granted`.
   * @throws TypeError when the port is not one of this object's.
   */
  replug(port: MockSerialPort): void {
    const hardware = this.#hardware(port);
    if (hardware.plugged) return;
    hardware.replug();
    this.#announce('connect', port);
  }

  /** What the user answers to the chooser from now on: a port, or null to dismiss it. */
  choose(port: MockSerialPort | null): void {
    this.#choice = port;
  }

  /**
   * The `getPorts()` method: the ports that are plugged in and that the site may use, in the order in which they came.
   */
  async getPorts(): Promise<MockSerialPort[]> {
    return [...this.#ports].filter(([, { plugged, granted }]) => plugged && granted).map(([port]) => port);
  }

  /**
   * The `requestPort()` method. The site may use the port that the user chooses.
   * @throws SecurityError without user activation.
   * @throws TypeError when a filter is empty, has a product without its vendor or USB numbers beside a Bluetooth
   *   service class, or when a service class is none.
   * @throws NotFoundError when the user dismisses the chooser, or when it would not offer the chosen port: because it
   *   is unplugged, matches no filter, or is one of a Bluetooth service class that the request does not allow.
   */
  async requestPort(options: PortRequestOptions = {}): Promise<MockSerialPort> {
    if (!this.userActivation) {
      throw new DOMException('Must be handling a user gesture to show a permission request.', 'SecurityError');
    }
    const isOffered = offered(options);
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
