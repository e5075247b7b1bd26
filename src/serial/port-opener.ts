import type { Clock } from '../line/index.js';
import { ConnectionError } from './errors.js';
import type { OpenedSettings } from './settings.js';
import type { SerialPortLike } from './types.js';

/** The browser's own default of 255 bytes overflows when the page is busy for a moment. */
const BUFFER_SIZE = 16 * 1024;
/** Milliseconds after which a port that does not close, such as a Bluetooth port out of reach, is left to itself. */
const LONGEST_CLOSE = 3000;

/** A port that is opened and closed, at one rate after another, never twice at a time. Its streams belong to others. */
export class PortOpener {
  readonly port: SerialPortLike;
  readonly #clock: Clock;
  #open: OpenedSettings | null = null;

  constructor(port: SerialPortLike, clock: Clock) {
    this.port = port;
    this.#clock = clock;
  }

  /** How the port is open; null while it is closed. */
  get settings(): OpenedSettings | null {
    return this.#open;
  }

  /**
   * Opens the port, closing it before if it is open otherwise.
   * @throws ConnectionError `busy`, `unplugged` or `bad-settings`. Whatever came of it, it is closed by {@link close}.
   */
  async open(settings: OpenedSettings): Promise<void> {
    if (this.#open?.baudRate === settings.baudRate) return;
    await this.close();
    const { baudRate, dataBits, stopBits, parity } = settings;
    try {
      await this.port.open({ baudRate, dataBits, stopBits, parity, bufferSize: BUFFER_SIZE });
      this.#open = settings;
      await this.#setSignals(settings);
    } catch (error) {
      throw this.#refusal(error);
    }
  }

  /** Closes the port. Never throws: one that is unplugged may refuse, and there is nothing left to close then. */
  async close(): Promise<void> {
    if (!this.#open) return;
    this.#open = null;
    let cancel: () => void = () => {};
    const late = new Promise<void>((resolve) => {
      cancel = this.#clock.after(LONGEST_CLOSE, resolve);
    });
    await Promise.race([this.port.close().catch(() => {}), late]);
    cancel();
  }

  async #setSignals({ dtr, rts }: OpenedSettings): Promise<void> {
    if (dtr === null && rts === null) return;
    if (!this.port.setSignals) throw new TypeError('this port has no setSignals()');
    await this.port.setSignals({
      ...(dtr !== null && { dataTerminalReady: dtr }),
      ...(rts !== null && { requestToSend: rts }),
    });
  }

  #refusal(error: unknown): ConnectionError {
    if (this.port.connected === false) return new ConnectionError('unplugged', 'the port is not plugged in', error);
    const isUnfit = error instanceof TypeError || (error instanceof DOMException && error.name === 'NotSupportedError');
    // A port that is open already does not take how DTR and RTS are to stand.
    if (isUnfit || this.#open)
      return new ConnectionError('bad-settings', 'the port does not take these settings', error);
    return new ConnectionError('busy', 'the port cannot be opened', error);
  }
}
