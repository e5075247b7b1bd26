import { BITS_PER_BYTE, ByteLine, type Bytes, type Clock, soon } from '../line/index.js';
import type { OpenedOptions, PlugOptions } from './types.js';

/** For lines that take no time: everything is due at once, but never before the caller has gone on. */
const promptClock: Clock = { now: () => 0, after: (_ms, callback) => soon(callback) };

/** What is connected to the two ends of a cable. */
export interface CableEnds {
  /** Called when bytes reach the device, which may keep the array. */
  toDevice(bytes: Bytes): void;
  /** Called when bytes reach the port, which may keep the array. */
  toPage(bytes: Bytes): void;
}

/** The two lines between a port and its device. */
export class Cable {
  /** The clock by which bytes move. */
  readonly clock: Clock;
  readonly #ends: CableEnds;
  readonly #options: PlugOptions;
  #toDevice: ByteLine;
  #toPage: ByteLine;
  /** When everything that was sent to the page has arrived. */
  #dueAtPage = 0;

  constructor(ends: CableEnds, options: PlugOptions & { readonly clock: Clock }) {
    const { timing = false, latency = 0 } = options;
    this.clock = timing || latency > 0 ? options.clock : promptClock;
    this.#ends = ends;
    this.#options = options;
    [this.#toDevice, this.#toPage] = this.#lay();
  }

  /**
   * Sets how long bytes take, by the options with which the port is open. Does nothing when this cable has no timing.
   */
  setRate({ baudRate, dataBits, parity, stopBits }: OpenedOptions): void {
    if (!this.#options.timing) return;
    const bits = 1 + dataBits + (parity === 'none' ? 0 : 1) + stopBits;
    this.#toDevice.baudRate = (baudRate * BITS_PER_BYTE) / bits;
    this.#toPage.baudRate = this.#toDevice.baudRate;
  }

  /** @returns the time on `clock` at which the last of the bytes will have left the port. */
  sendToDevice(bytes: Uint8Array): number {
    return this.#toDevice.send(bytes);
  }

  sendToPage(bytes: Uint8Array): void {
    this.#dueAtPage = this.#toPage.send(bytes) + (this.#options.latency ?? 0);
  }

  /**
   * Calls `callback` once everything sent to the page before has arrived, never before this call has returned; never if
   * the cable is cut first.
   */
  behindToPage(callback: () => void): void {
    const line = this.#toPage;
    this.clock.after(this.#dueAtPage - this.clock.now(), () => line === this.#toPage && callback());
  }

  /** Drops the bytes on their way to the device. */
  dropToDevice(): void {
    this.#toDevice.clear();
  }

  /** Cuts the cable: drops the bytes on their way in either direction. What is sent from now on gets lost, too. */
  cut(): void {
    this.#toDevice.cut();
    this.#toPage.cut();
  }

  /** Connects a cable again that was cut. */
  mend(): void {
    [this.#toDevice, this.#toPage] = this.#lay();
  }

  #lay(): [toDevice: ByteLine, toPage: ByteLine] {
    const { clock } = this;
    const { latency = 0, chunks = [], fault = {} } = this.#options;
    const { toDevice, toPage } = fault;
    return [
      new ByteLine((bytes) => this.#ends.toDevice(bytes), { clock, latency, ...(toDevice && { fault: toDevice }) }),
      new ByteLine((bytes) => this.#ends.toPage(bytes), { clock, latency, chunks, ...(toPage && { fault: toPage }) }),
    ];
  }
}
