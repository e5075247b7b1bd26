import type { Bytes } from '../line/index.js';
import { invalidState, networkError } from './errors.js';
import { ConnectionTarget } from './events.js';
import type { Hardware } from './hardware.js';
import { checkOpenOptions, convertOpenOptions } from './open-options.js';
import type { InputSignals, MockDevice, OpenOptions, OutputSignals, PortInfo } from './types.js';
import { asInterface, defined, dictionary, given } from './web-idl.js';

/**
 * A `SerialPort` of the Web Serial standard, with a `device` at its other end. `MockSerial.plug` makes one.
 *
 * Where the standard and Chromium differ, the port follows the web platform tests: the stream of bytes has a high-water
 * mark of 0, a system error while writing brings a new `writable`, and `open()` after `forget()` fails with
 * NetworkError.
 */
export class MockSerialPort extends ConnectionTarget {
  static {
    const attributes = ['onconnect', 'ondisconnect', 'connected', 'readable', 'writable'];
    const methods = ['getInfo', 'open', 'setSignals', 'getSignals', 'close', 'forget'];
    asInterface(MockSerialPort.prototype, 'SerialPort', [...attributes, ...methods]);
  }

  readonly #hardware: Hardware;
  /** Whether a browser would end the tab at the next touch of `readable`: see `ChromiumWays.failedCloseKills`. */
  #isDeadly = false;
  /** The standard's [[state]]. */
  #state: 'closed' | 'opening' | 'opened' | 'closing' = 'closed';

  /** Use `MockSerial.plug`. */
  constructor(hardware: Hardware, serial: ConnectionTarget) {
    super(serial);
    this.#hardware = hardware;
  }

  /** The other end of the port. */
  get device(): MockDevice {
    return this.#hardware.device;
  }

  /** The `connected` attribute: whether the port is plugged in. After `forget()` it does not change any more. */
  get connected(): boolean {
    return this.#hardware.connected;
  }

  /**
   * The `readable` attribute: a byte stream while the port is open, else null. An error ends the stream after all bytes
   * that came before it. Then there is a new stream; after the loss of the device, null.
   */
  get readable(): ReadableStream<Bytes> | null {
    if (this.#isDeadly)
      throw new Error('Chromium kills the tab here: close() had failed before because writable was locked.');
    if (this.#state === 'closing' && this.#hardware.follows('closingHidesReadable')) return null;
    const { receiver } = this.#hardware;
    return receiver.stream ?? (this.#state === 'opened' ? receiver.createStream() : null);
  }

  /**
   * The `writable` attribute: a stream of BufferSources while the port is open, else null; replaced like `readable`.
   */
  get writable(): WritableStream<Uint8Array> | null {
    const { transmitter } = this.#hardware;
    return transmitter.stream ?? (this.#state === 'opened' ? transmitter.createStream() : null);
  }

  /** The `getInfo()` method. */
  getInfo(): PortInfo {
    return { ...this.#hardware.info };
  }

  /**
   * The `open()` method. Raises DTR.
   * @throws TypeError when the baud rate is missing or another option is out of its range.
   * @throws InvalidStateError when the port is not closed.
   * @throws NetworkError when the device is busy or unplugged, or the port was forgotten.
   */
  async open(options: OpenOptions): Promise<void> {
    const converted = convertOpenOptions(options);
    if (this.#state !== 'closed') throw invalidState(`The port is ${this.#state}.`);
    checkOpenOptions(converted);
    this.#state = 'opening';
    await null;
    try {
      this.#hardware.open(converted);
      this.#state = 'opened';
    } catch (error) {
      this.#state = 'closed';
      throw error;
    }
  }

  /**
   * The `close()` method. Discards what has not been read or sent, and drops DTR.
   * @throws InvalidStateError when the port is not open.
   * @throws TypeError when `readable` or `writable` is locked; the port stays open.
   */
  async close(): Promise<void> {
    this.#checkOpened();
    const readable = this.#hardware.receiver.stream;
    const writable = this.#hardware.transmitter.stream;
    if (readable?.locked) throw new TypeError('Cannot close the port while its readable is locked.');
    const cancelled = readable?.cancel();
    if (writable?.locked) {
      this.#isDeadly = this.#hardware.follows('failedCloseKills') && readable !== null;
      throw new TypeError('Cannot close the port while its writable is locked.');
    }
    this.#isDeadly = false;
    this.#state = 'closing';
    // A stream that fails now does not keep the port open. But a stream that broke on a chunk of the wrong type keeps
    // it open for ever, because nothing ends that stream. The standard and Chromium do the same, so a page must cope
    // with it.
    await Promise.allSettled([cancelled, writable?.abort(invalidState('The port is closed.'))]);
    await this.#hardware.transmitter.ended;
    if (this.#state !== 'closing') return;
    this.#hardware.close();
    this.#state = 'closed';
  }

  /**
   * The `forget()` method: the site gives up its permission. An open port is closed as if its device were lost; bytes
   * that have arrived can still be read.
   */
  async forget(): Promise<void> {
    this.#hardware.forget();
    this.#state = 'closed';
  }

  /**
   * The `setSignals()` method.
   * @throws InvalidStateError when the port is not open.
   * @throws TypeError when no signal is given.
   * @throws NetworkError when the device is unplugged or fails.
   */
  async setSignals(signals: OutputSignals = {}): Promise<void> {
    const set = defined(converted(signals));
    this.#checkOpened();
    if (Object.keys(set).length === 0) throw new TypeError('At least one signal must be given.');
    this.#checkSignals('Failed to set control signals.');
    const { device } = this.#hardware;
    device.signals = { ...device.signals, ...set };
  }

  /**
   * The `getSignals()` method.
   * @throws InvalidStateError when the port is not open.
   * @throws NetworkError when the device is unplugged or fails.
   */
  async getSignals(): Promise<InputSignals> {
    this.#checkOpened();
    this.#checkSignals('Failed to get control signals.');
    return { ...this.#hardware.device.input };
  }

  #checkOpened(): void {
    if (this.#state !== 'opened') throw invalidState(`The port is ${this.#state}.`);
  }

  #checkSignals(message: string): void {
    if (!this.#hardware.plugged || this.#hardware.device.failSignals) throw networkError(message);
  }
}

/** What Web IDL does to the argument of `setSignals()`. @throws TypeError */
function converted(signals: OutputSignals): OutputSignals {
  const of = dictionary(signals);
  return {
    break: given(of.break, Boolean),
    dataTerminalReady: given(of.dataTerminalReady, Boolean),
    requestToSend: given(of.requestToSend, Boolean),
  };
}
