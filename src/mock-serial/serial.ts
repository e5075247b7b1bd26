import { type Clock, realClock } from '../line/index.js';
import { announce, ConnectionTarget } from './events.js';
import { convertRequestOptions, offered } from './filters.js';
import { Hardware } from './hardware.js';
import { MockSerialPort } from './port.js';
import type { FollowsWay, MockSerialOptions, PlugOptions, PortInfo, PortRequestOptions } from './types.js';
import { asInterface } from './web-idl.js';

/**
 * A `navigator.serial` without a browser: the `Serial` of the Web Serial standard, and the acts of a user: plug,
 * unplug, choose. At first nothing is plugged in, the user has touched nothing, and dismisses every chooser.
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
  static {
    asInterface(MockSerial.prototype, 'Serial', ['onconnect', 'ondisconnect', 'getPorts', 'requestPort']);
  }

  #userActivation: boolean;
  readonly #clock: Clock;
  readonly #follows: FollowsWay;
  readonly #ports = new Map<MockSerialPort, Hardware>();
  #choice: MockSerialPort | null = null;

  /** @param options the clock, user activation, and ways of Chromium. Default: none of these. */
  constructor(options: MockSerialOptions = {}) {
    const { chromium = false } = options;
    const follows: FollowsWay = (way) => (typeof chromium === 'object' ? chromium[way] === true : chromium);
    super(null, follows('onceNeverFires'));
    this.#follows = follows;
    this.#clock = options.clock ?? realClock;
    this.#userActivation = options.userActivation ?? false;
  }

  /**
   * Whether `requestPort()` may ask the user, as just after a click. Its value stays: the standard does not use it up.
   */
  get userActivation(): boolean {
    return this.#userActivation;
  }

  set userActivation(isActive: boolean) {
    this.#userActivation = isActive;
  }

  /**
   * Plugs in a device at a new port. If the site may use it already, the event `connect` follows, never before this
   * call has returned.
   * @throws TypeError when the information names an invalid Bluetooth service class or USB number.
   */
  plug(info: PortInfo = {}, options: PlugOptions = {}): MockSerialPort {
    const clock = options.clock ?? this.#clock;
    return this.#bring(new Hardware(info, { ...options, clock, follows: this.#follows }));
  }

  /**
   * Pulls the plug. Bytes on their way in either direction are lost; bytes that have arrived can still be read. Then,
   * or at once if the page waits, reading and writing fail with NetworkError. The event `disconnect` follows if the
   * site may use the port.
   * @throws TypeError when the port is not one of this object's.
   */
  unplug(port: MockSerialPort): void {
    const hardware = this.#hardware(port);
    if (!hardware.plugged) return;
    hardware.unplug();
    this.#announce('disconnect', port);
  }

  /**
   * Plugs a device in again, and the browser recognises it. A wired device comes back as another port, with the same
   * `device` and the same permission. The old port stays unplugged for good, and its `open()` fails with NetworkError.
   * A Bluetooth device comes back as the same port; the page must close it before it can use it again. For a device
   * that the browser does not recognise, use `plug` with the same information.
   * @param options `samePort`: a wired device, too, comes back as the same port. Default false.
   * @returns the port at which the device is now.
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

  /** Sets what the user chooses from now on: a port, or null to dismiss the chooser. */
  choose(port: MockSerialPort | null): void {
    this.#choice = port;
  }

  /**
   * The `getPorts()` method: the ports that are plugged in and that the site may use, in the order in which they came.
   * A Bluetooth port is listed even while it is off.
   */
  async getPorts(): Promise<MockSerialPort[]> {
    return [...this.#ports].filter(([, it]) => it.granted && (it.plugged || it.isBluetooth)).map(([port]) => port);
  }

  /**
   * The `requestPort()` method. The site may use the port that the user chooses.
   * @throws TypeError when the argument has a wrong type, such as filters that are not a list.
   * @throws SecurityError without user activation.
   * @throws TypeError when a filter is empty, names a product without its vendor, or USB numbers together with a
   * Bluetooth service class, or when a service class is not valid.
   * @throws NotFoundError when the user dismisses the chooser, or when the chooser would not offer the chosen port: it
   * is unplugged, matches no filter, or has a Bluetooth service class that the request does not allow.
   */
  async requestPort(options: PortRequestOptions = {}): Promise<MockSerialPort> {
    const converted = convertRequestOptions(options);
    if (!this.#userActivation) {
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
    queueMicrotask(() => announce(port, type));
  }
}
