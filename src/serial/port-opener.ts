import type { Clock } from '../line/index.js';
import { ConnectionError } from './errors.js';
import type { OpenedSettings } from './settings.js';
import type { SerialPortLike } from './types.js';

/** The browser's default of 255 bytes overflows when the page is busy for a moment. */
const BUFFER_SIZE = 16 * 1024;
/**
 * Milliseconds after which a port that does not close, such as a Bluetooth port out of reach, is no longer waited for.
 */
const LONGEST_CLOSE = 3000;

/** Opens and closes a port, at one rate after another, never twice at a time. It does not touch the streams. */
export class PortOpener {
  readonly port: SerialPortLike;
  readonly #clock: Clock;
  #open: OpenedSettings | null = null;

  constructor(port: SerialPortLike, clock: Clock) {
    this.port = port;
    this.#clock = clock;
  }

  /** The settings of the open port; null while it is closed. */
  get settings(): OpenedSettings | null {
    return this.#open;
  }

  /**
   * Opens the port. Closes it first if it is open with other settings.
   * @throws ConnectionError `busy`, `unplugged` or `bad-settings`. Use {@link close} afterwards in any case.
   */
  async open(settings: OpenedSettings): Promise<void> {
    if (this.#open && this.#open.baudRate === settings.baudRate) return;
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

  /** Closes the port. Never throws: an unplugged port may refuse, and then nothing is left to close. */
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
    // A port that is already open has refused the settings of DTR and RTS.
    if (isUnfit || this.#open)
      return new ConnectionError('bad-settings', 'the port does not take these settings', error);
    return new ConnectionError('busy', 'the port cannot be opened', error);
  }
}
