import { type Clock, VirtualClock } from '../../src/line/index.js';
import { MockSerial, type MockSerialPort, type PlugOptions, type PortInfo } from '../../src/mock-serial/index.js';
import type { SerialPortLike } from '../../src/serial/index.js';
import { VirtualTimer, type VirtualTimerOptions } from '../../src/simulator/index.js';

export interface TimerOptions extends Omit<VirtualTimerOptions, 'clock'> {
  readonly info?: PortInfo;
  readonly plug?: PlugOptions;
  readonly clock?: Clock;
  /** The only rate at which timer and page understand each other. Default: every rate. */
  readonly answersAt?: number;
  /** At any other rate something comes back for each byte of the page, because both ends take noise for bytes. */
  readonly noise?: boolean;
  /** Milliseconds before each byte of the timer, which then come one by one. Default: as they leave it. */
  readonly gap?: number;
}

/** An adapter on a mock port, with a virtual timer in front of its infrared head. */
export class Adapter {
  readonly timer: VirtualTimer;
  answersAt: number | undefined;
  readonly #serial: MockSerial;
  readonly #info: PortInfo;
  readonly #plug: PlugOptions;
  readonly #noise: boolean;
  #port: MockSerialPort;
  readonly #toTimer: WritableStreamDefaultWriter<Uint8Array>;
  /** After how many more bytes of the timer something is to happen. */
  #left = Number.POSITIVE_INFINITY;
  #then: () => void = () => {};

  constructor(serial: MockSerial, options: TimerOptions = {}) {
    const { info = {}, plug = {}, answersAt, noise = false, gap = 0, ...timerOptions } = options;
    this.#serial = serial;
    this.#info = info;
    this.#plug = { granted: true, ...plug };
    this.#port = serial.plug(info, this.#plug);
    this.answersAt = answersAt;
    this.#noise = noise;
    this.timer = new VirtualTimer(timerOptions);
    this.#toTimer = this.timer.writable.getWriter();
    void this.#hear();
    void this.timer.readable.pipeTo(new WritableStream({ write: (bytes) => this.#say(bytes, gap, options.clock) }));
  }

  get port(): MockSerialPort {
    return this.#port;
  }

  unplug(): void {
    this.#serial.unplug(this.port);
  }

  /** Pulls the plug after so many more bytes of the timer. */
  unplugAfter(bytes: number): void {
    // On a line that takes no time, written bytes arrive at the end of this turn.
    this.after(bytes, () => queueMicrotask(() => this.unplug()));
  }

  /** Acts after so many more bytes of the timer. */
  after(bytes: number, then: () => void): void {
    this.#left = bytes;
    this.#then = then;
  }

  /** The browser recognises it: a wired adapter comes back as another port, a Bluetooth adapter as the same one. */
  replug(options: { readonly samePort?: boolean } = {}): void {
    this.#port = this.#serial.replug(this.port, options);
    void this.#hear();
  }

  /** Plugs it in again without the browser recognising it: at another port. */
  returnAsNew(): void {
    this.#port = this.#serial.plug(this.#info, this.#plug);
    void this.#hear();
  }

  async #hear(): Promise<void> {
    const { device } = this.port;
    for (;;) {
      const bytes = await device.read();
      if (bytes.length === 0) return;
      if (this.#isUnderstood) await this.#toTimer.write(bytes);
      else if (this.#noise) device.write(bytes.map(garbled));
    }
  }

  get #isUnderstood(): boolean {
    return this.answersAt === undefined || this.port.device.opened?.baudRate === this.answersAt;
  }

  async #say(bytes: Uint8Array, gap: number, clock: Clock | undefined): Promise<void> {
    if (gap === 0 || !clock) return this.#sayNow(bytes);
    for (const byte of bytes) {
      await new Promise<void>((resolve) => clock.after(gap, resolve));
      this.#sayNow(Uint8Array.of(byte));
    }
  }

  #sayNow(said: Uint8Array): void {
    const { device } = this.port;
    // A late reply may come when the page has gone on to another rate.
    const bytes = this.#isUnderstood ? said : said.map(garbled);
    const before = bytes.subarray(0, this.#left);
    this.#left -= before.length;
    device.write(before);
    if (this.#left > 0) return;
    this.#left = Number.POSITIVE_INFINITY;
    this.#then();
    device.write(bytes.subarray(before.length));
  }
}

/** A byte as it is heard at the wrong rate. */
const garbled = (byte: number): number => byte ^ 0x5a;

/** A browser's serial ports, one adapter and a timer, all on one clock that the test turns. */
export function serialBench(options: TimerOptions = {}) {
  const clock = new VirtualClock(1_700_000_000_000);
  const serial = new MockSerial({ clock, userActivation: true });
  const adapter = new Adapter(serial, { clock, ...options });
  return { clock, serial, adapter, port: adapter.port, timer: adapter.timer };
}

/** What a promise rejects with. */
export function failure(promise: Promise<unknown>): Promise<unknown> {
  return promise.then(
    () => 'none',
    (error: unknown) => error,
  );
}

/** Whether the port can be opened: it is closed and plugged in. */
export async function canBeOpened(port: SerialPortLike): Promise<boolean> {
  try {
    await port.open({ baudRate: 9600 });
    await port.close();
    return true;
  } catch {
    return false;
  }
}

/** Makes everything on a port answer what no timer can be: a version with a right checksum and no functions. */
export async function answerNonsense({ device }: MockSerialPort): Promise<void> {
  const impossible = [0, 0, 0, 0, 0, 0x0c, 0x6c, 0x42, 0x35, 0x33, 0x36, 0x20, 0, 4, 3, 0x20, 0x93, 0x45];
  while ((await device.read()).length > 0) device.write(impossible);
}
