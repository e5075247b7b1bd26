import { BITS_PER_BYTE, ByteLine, type ByteLineOptions, type Bytes, type Clock } from '../line/index.js';
import type { OpenedOptions, PlugOptions } from './types.js';

/** For lines that take no time: everything is due at once, but never before the caller has gone on. */
const promptClock: Clock = {
  now: () => 0,
  after(_ms, callback) {
    let due = true;
    queueMicrotask(() => {
      if (due) callback();
    });
    return () => {
      due = false;
    };
  },
};

/** What is connected to the two ends of a cable. */
export interface CableEnds {
  /** Called when bytes reach the device, which may keep the array. */
  toDevice(bytes: Bytes): void;
  /** Called when bytes reach the port, which may keep the array. */
  toPage(bytes: Bytes): void;
}

/**
 * The two lines between a port and its device, and the wires by which bytes return when a
 * test asks for echo or loopback.
 */
export class Cable {
  /** The clock by which bytes move. */
  readonly clock: Clock;
  /** Whether bytes move by the clock alone, even when the device does not read them. */
  readonly free: boolean;
  readonly #ends: CableEnds;
  readonly #options: PlugOptions;
  #toDevice: ByteLine;
  #toPage: ByteLine;
  #back: ByteLine;
  /**
   * How many bytes were sent to the page, and how many have arrived. What follows them waits until the two are equal.
   */
  #dueAtPage = 0;
  #arrivedAtPage = 0;
  #behind: { readonly due: number; readonly callback: () => void; readonly onCut: () => void }[] = [];

  constructor(ends: CableEnds, options: PlugOptions & { readonly clock: Clock }) {
    const timed = options.timing === true || (options.latency ?? 0) > 0;
    this.clock = timed ? options.clock : promptClock;
    this.free = timed || options.echo === true || options.loopback === true;
    this.#ends = ends;
    this.#options = options;
    [this.#toDevice, this.#toPage, this.#back] = this.#lay();
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
    if (!this.#options.fault?.toPage) this.#dueAtPage += bytes.length;
    this.#toPage.send(bytes);
  }

  /**
   * Calls `callback` once everything sent to the page before has arrived, never before this call has returned. Calls
   * `onCut` if it never will.
   */
  behindToPage(callback: () => void, onCut: () => void = () => {}): void {
    this.#behind.push({ due: this.#dueAtPage, callback, onCut });
    this.clock.after(0, () => this.#callBehind());
  }

  /** Drops the bytes on their way to the device. */
  dropToDevice(): void {
    this.#toDevice.clear();
  }

  /**
   * Drops the bytes on their way to the page where the line takes no time: they are in the port's buffer for anybody
   * who looks. Where it takes time they still come.
   */
  dropToPage(): void {
    if (this.clock !== promptClock) return;
    this.#toPage.clear();
    this.#dueAtPage = this.#arrivedAtPage;
    this.#cutBehind();
  }

  /** Cuts the cable: drops the bytes on their way in either direction. */
  cut(): void {
    for (const line of [this.#toDevice, this.#toPage, this.#back]) line.cut();
    this.#cutBehind();
  }

  #cutBehind(): void {
    const behind = this.#behind;
    this.#behind = [];
    for (const { onCut } of behind) onCut();
  }

  /** Connects a cable again that was cut. */
  mend(): void {
    this.#dueAtPage = 0;
    this.#arrivedAtPage = 0;
    [this.#toDevice, this.#toPage, this.#back] = this.#lay();
  }

  #lay(): [toDevice: ByteLine, toPage: ByteLine, back: ByteLine] {
    const { clock } = this;
    const { latency = 0, chunks, fault, echo, loopback } = this.#options;
    const toPage: ByteLineOptions = { clock, ...(chunks && { chunks }) };
    const damage = fault?.toPage;
    return [
      new ByteLine(
        (bytes) => {
          if (echo || loopback) this.#back.send(bytes);
          if (!loopback) this.#ends.toDevice(bytes);
        },
        { clock, latency, ...(fault?.toDevice && { fault: fault.toDevice }) },
      ),
      new ByteLine((bytes) => this.#reachPage(bytes), {
        ...toPage,
        latency,
        ...(damage && {
          fault: (byte: number, index: number) => {
            const arriving = damage(byte, index);
            this.#dueAtPage += arriving.length;
            return arriving;
          },
        }),
      }),
      // Returned bytes take no more time: they have had theirs on the way out.
      new ByteLine((bytes) => this.#ends.toPage(bytes), toPage),
    ];
  }

  #reachPage(bytes: Bytes): void {
    this.#arrivedAtPage += bytes.length;
    this.#ends.toPage(bytes);
    this.#callBehind();
  }

  #callBehind(): void {
    while (this.#behind[0] && this.#behind[0].due <= this.#arrivedAtPage) this.#behind.shift()?.callback();
  }
}
