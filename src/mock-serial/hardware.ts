import type { Clock } from '../line/index.js';
import { Cable } from './cable.js';
import { Device } from './device.js';
import { networkError } from './errors.js';
import { normalizeInfo } from './filters.js';
import { Receiver } from './receiver.js';
import { Transmitter } from './transmitter.js';
import type { FollowsWay, OpenedOptions, PlugOptions, PortInfo } from './types.js';

/** The options of a plugged port, with the browser's ways that it follows. */
export interface HardwareOptions extends PlugOptions {
  readonly clock: Clock;
  readonly follows: FollowsWay;
}

/**
 * What lies behind a port: the buffers of the operating system, the cable and the device at its end, plugged in or not.
 */
export class Hardware {
  readonly info: PortInfo;
  readonly device: Device;
  readonly cable: Cable;
  readonly receiver = new Receiver();
  readonly transmitter: Transmitter;
  plugged = true;
  /** Whether the site has been told that it is plugged in. */
  connected = true;
  /** Whether the site may use the port. */
  granted: boolean;
  /** Whether the site gave the port up and has not been granted it again. */
  forgotten = false;
  readonly #options: HardwareOptions;
  /** Whether the device is at another port now. */
  #isLeft = false;
  /** Whether it was given up since it was last opened. */
  #wasForgotten = false;

  /** @throws TypeError when the information names an invalid Bluetooth service class. */
  constructor(info: PortInfo, options: HardwareOptions, device?: Device) {
    this.info = normalizeInfo(info);
    this.#options = options;
    this.granted = options.granted ?? false;
    this.device = device ?? new Device(this, options.busy ?? false);
    this.cable = new Cable(
      { toDevice: (bytes) => this.device.arrive(bytes), toPage: (bytes) => this.receiver.push(bytes) },
      options,
    );
    this.transmitter = new Transmitter(this.cable, options.follows);
  }

  /** The browser's ways that it follows. */
  get follows(): FollowsWay {
    return this.#options.follows;
  }

  /** Whether the browser finds it again without help, and calls it the same port. */
  get isBluetooth(): boolean {
    return this.info.bluetoothServiceClassId !== undefined;
  }

  /** Another port with the same device, for a wired device that is plugged in again. */
  again(): Hardware {
    const { granted, device } = this;
    const hardware = new Hardware(this.info, { ...this.#options, granted }, device);
    this.#isLeft = true;
    device.moveTo(hardware);
    return hardware;
  }

  /** @throws NetworkError when the port is unplugged, forgotten or held by another program. */
  open(options: OpenedOptions): void {
    if (!this.plugged || this.forgotten || this.device.busy) throw networkError('Failed to open serial port.');
    this.cable.setRate(options);
    const { follows } = this.#options;
    const hasHandshake = options.flowControl === 'hardware';
    const isPatient = hasHandshake || follows('bufferNeverOverruns');
    this.receiver.open(options.bufferSize, isPatient, follows('forgottenStreamReturns') && this.#wasForgotten);
    this.#wasForgotten = false;
    this.transmitter.open(options.bufferSize);
    const requestToSend = hasHandshake || follows('openRaisesRts');
    this.device.signals = { dataTerminalReady: true, requestToSend, break: false };
    this.device.setOpened(options);
  }

  close(): void {
    this.receiver.close();
    this.#letGo();
  }

  #letGo(): void {
    this.transmitter.close();
    if (!this.#isLeft) this.device.letGo();
  }

  forget(): void {
    this.granted = false;
    this.forgotten = true;
    this.#wasForgotten = true;
    this.receiver.fail('lost');
    this.transmitter.abandon();
    this.#letGo();
  }

  unplug(): void {
    this.plugged = false;
    if (!this.forgotten) this.connected = false;
    this.cable.cut();
    this.receiver.fail('lost');
    this.transmitter.lose();
    this.device.unplug();
  }

  replug(): void {
    this.plugged = true;
    this.connected = true;
    this.cable.mend();
    this.device.replug();
  }
}
