import { type Clock, VirtualClock } from '../../src/line/index.js';
import { MockSerial, type MockSerialPort, type PlugOptions, type PortInfo } from '../../src/mock-serial/index.js';
import { VirtualTimer, type VirtualTimerOptions } from '../../src/simulator/index.js';

export interface TimerOptions extends Omit<VirtualTimerOptions, 'clock'> {
  readonly info?: PortInfo;
  readonly plug?: PlugOptions;
  readonly clock?: Clock;
}

/** An adapter at a port of the mock, with a virtual timer in front of its infra-red head. */
export class Adapter {
  readonly port: MockSerialPort;
  readonly timer: VirtualTimer;
  readonly #serial: MockSerial;
  readonly #toTimer: WritableStreamDefaultWriter<Uint8Array>;
  /** What is to happen once the timer has sent so many more bytes. */
  #left = Number.POSITIVE_INFINITY;
  #then: () => void = () => {};

  constructor(serial: MockSerial, { info = {}, plug = {}, ...timerOptions }: TimerOptions = {}) {
    this.#serial = serial;
    this.port = serial.plug(info, { granted: true, ...plug });
    this.timer = new VirtualTimer(timerOptions);
    this.#toTimer = this.timer.writable.getWriter();
    void this.#hear();
    void this.timer.readable.pipeTo(new WritableStream({ write: (bytes) => this.#say(bytes) }));
  }

  unplug(): void {
    this.#serial.unplug(this.port);
  }

  /** Pulls the plug behind so many more bytes of the timer. */
  unplugAfter(bytes: number): void {
    // On a line that takes no time, what was written arrives when this turn is over.
    this.after(bytes, () => queueMicrotask(() => this.unplug()));
  }

  /** Lets something happen behind so many more bytes of the timer. */
  after(bytes: number, then: () => void): void {
    this.#left = bytes;
    this.#then = then;
  }

  /** At the same port as before: the browser recognises it. */
  replug(): void {
    this.#serial.replug(this.port);
    void this.#hear();
  }

  async #hear(): Promise<void> {
    for (;;) {
      const bytes = await this.port.device.read();
      if (bytes.length === 0) return;
      await this.#toTimer.write(bytes);
    }
  }

  #say(bytes: Uint8Array): void {
    const { device } = this.port;
    const before = bytes.subarray(0, this.#left);
    this.#left -= before.length;
    device.write(before);
    if (this.#left > 0) return;
    this.#left = Number.POSITIVE_INFINITY;
    this.#then();
    device.write(bytes.subarray(before.length));
  }
}

/** A browser's serial ports, one adapter and a timer, all on one clock that is turned by hand. */
export function serialBench(options: TimerOptions = {}) {
  const clock = new VirtualClock(1_700_000_000_000);
  const serial = new MockSerial({ clock, userActivation: true });
  const adapter = new Adapter(serial, { clock, ...options });
  return { clock, serial, adapter, port: adapter.port, timer: adapter.timer };
}
