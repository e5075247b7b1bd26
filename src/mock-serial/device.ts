import type { Bytes } from '../line/index.js';
import type { Cable } from './cable.js';
import { READ_ERROR_KINDS } from './errors.js';
import type { Receiver } from './receiver.js';
import type { Transmitter } from './transmitter.js';
import type {
  FollowsWay,
  InputSignals,
  MockDevice,
  OpenedOptions,
  ReadErrorKind,
  SetSignals,
  WriteErrorKind,
} from './types.js';
import { defined, oneOf } from './web-idl.js';

const WRITE_ERROR_KINDS: readonly string[] = ['system', 'lost'] satisfies WriteErrorKind[];

/** What lies between the device and the page, as far as the device can reach it. */
export interface PortSide {
  readonly follows: FollowsWay;
  readonly cable: Cable;
  readonly receiver: Receiver;
  readonly transmitter: Transmitter;
}

/** What a closed port leaves set. */
export const NO_SIGNALS: SetSignals = { dataTerminalReady: false, requestToSend: false, break: false };

/** The device's end of the cable: the bytes that have arrived, and the reads that wait for more. */
export class Device implements MockDevice {
  opened: OpenedOptions | null = null;
  onopenchange: ((opened: OpenedOptions | null) => void) | null = null;
  busy: boolean;
  failSignals = false;
  signals = NO_SIGNALS;
  /** What it has set itself. */
  input: InputSignals = { clearToSend: false, dataCarrierDetect: false, dataSetReady: false, ringIndicator: false };
  #port: PortSide;
  #unplugged = false;
  /** Bytes that were written here without a cable, and bytes that earlier ports of this device have lost. */
  #unsent = 0;
  #arrived: Bytes[] = [];
  #readers: ((bytes: Bytes) => void)[] = [];
  #replugged: () => void = () => {};

  constructor(port: PortSide, busy: boolean) {
    this.#port = port;
    this.busy = busy;
  }

  get lost(): number {
    return this.#unsent + this.#port.receiver.lost;
  }

  read(): Promise<Bytes> {
    const bytes = this.#arrived.shift();
    if (bytes) return Promise.resolve(bytes);
    if (this.#unplugged) return Promise.resolve(new Uint8Array());
    return new Promise((resolve) => this.#readers.push(resolve));
  }

  write(bytes: ArrayLike<number>): void {
    const sent = copyOf(bytes);
    if (this.#unplugged) this.#unsent += sent.length;
    else this.#port.cable.sendToPage(sent);
  }

  join({ readable, writable }: Parameters<MockDevice['join']>[0]): void {
    const toPage = readable.pipeTo(new WritableStream({ write: (bytes) => this.write(bytes) }));
    Promise.all([toPage, this.#feed(writable.getWriter())]).catch(() => {});
  }

  async #feed(writer: WritableStreamDefaultWriter<Uint8Array>): Promise<never> {
    for (;;) {
      const bytes = await this.read();
      if (bytes.length > 0) await writer.write(bytes);
      else if (this.#unplugged) await new Promise<void>((resolve) => (this.#replugged = resolve));
    }
  }

  error(kind: ReadErrorKind): void {
    oneOf(kind, READ_ERROR_KINDS, 'kind');
    const { cable, receiver, follows } = this.#port;
    const follow = (): void => cable.behindToPage(() => receiver.fail(kind));
    if (kind === 'break' && follows('breakComesLast')) queueMicrotask(follow);
    else follow();
  }

  setSignals(signals: Partial<InputSignals>): void {
    this.input = { ...this.input, ...defined(signals) };
  }

  failNextWrite(kind: WriteErrorKind = 'system'): void {
    oneOf(kind, WRITE_ERROR_KINDS, 'kind');
    this.#port.transmitter.failNext(kind);
  }

  /** Takes bytes that reach the device. */
  arrive(bytes: Bytes): void {
    const reader = this.#readers.shift();
    if (reader) reader(bytes);
    else this.#arrived.push(bytes);
  }

  setOpened(opened: OpenedOptions | null): void {
    if (opened === this.opened) return;
    this.opened = opened;
    this.onopenchange?.(opened);
  }

  /** The page has closed the port, or lost it. */
  letGo(): void {
    this.signals = NO_SIGNALS;
    this.setOpened(null);
  }

  unplug(): void {
    this.#unplugged = true;
    const readers = this.#readers;
    this.#readers = [];
    for (const resolve of readers) resolve(new Uint8Array());
  }

  replug(): void {
    this.#unplugged = false;
    this.#replugged();
  }

  /** The device was plugged in at another port. */
  moveTo(port: PortSide): void {
    this.#unsent = this.lost;
    this.#port = port;
    this.letGo();
    this.replug();
  }
}

/** @throws TypeError unless all of them are bytes. */
function copyOf(bytes: ArrayLike<number>): Uint8Array {
  const isByte = (value: number): boolean => Number.isInteger(value) && value >= 0 && value <= 255;
  if (Number.isInteger(bytes?.length) && Array.from(bytes).every(isByte)) return Uint8Array.from(bytes);
  throw new TypeError('bytes must be a list of whole numbers from 0 to 255.');
}
