import type { Clock } from '../line/index.js';
import { ConnectionError } from './errors.js';
import type { OpenedSettings } from './settings.js';
import type { SerialPortLike } from './types.js';

/** The browser's default of 255 bytes overflows when the page is busy for a moment. */
const BUFFER_SIZE = 16 * 1024;
/**
 * Milliseconds after which a port that does not open or close, such as a Bluetooth port out of reach, is no longer
 * waited for once it is to be closed.
 */
const LONGEST_WAIT = 3000;

/** Opens and closes a port, at one rate after another, never twice at a time. It does not touch the streams. */
export class PortOpener {
  readonly port: SerialPortLike;
  readonly #clock: Clock;
  /** The settings of the open port; null while it is closed. */
  settings: OpenedSettings | null = null;

  constructor(port: SerialPortLike, clock: Clock) {
    this.port = port;
    this.#clock = clock;
  }

  /**
   * Opens the port. Closes it first if it is open with other settings.
   * @param stop aborts when the port is wanted no longer. A port that still opens later is closed then.
   * @throws ConnectionError `busy`, `unplugged` or `bad-settings`. Use {@link close} afterwards in any case.
   */
  async open(settings: OpenedSettings, stop: AbortSignal): Promise<void> {
    if (this.settings && this.settings.baudRate === settings.baudRate) return;
    await this.close();
    const { baudRate, dataBits, stopBits, parity } = settings;
    try {
      const opening = this.port.open({ baudRate, dataBits, stopBits, parity, bufferSize: BUFFER_SIZE });
      if (!(await this.#settles(opening, stop))) {
        opening.then(() => this.port.close()).catch(() => {});
        return;
      }
      this.settings = settings;
      await this.#settles(this.#setSignals(settings), stop);
    } catch (error) {
      throw this.#refusal(error);
    }
  }

  /** Closes the port. Never throws: an unplugged port may refuse, and then nothing is left to close. */
  async close(): Promise<void> {
    if (!this.settings) return;
    this.settings = null;
    await this.#settles(this.port.close(), AbortSignal.abort()).catch(() => {});
  }

  /** Waits for what the port was asked for. @returns false if it took too long after `stop`. */
  async #settles(asked: Promise<void>, stop: AbortSignal): Promise<boolean> {
    let cancel: () => void = () => {};
    const late = new Promise<boolean>((resolve) => {
      const count = (): void => {
        cancel = this.#clock.after(LONGEST_WAIT, () => resolve(false));
      };
      if (stop.aborted) return count();
      stop.addEventListener('abort', count, { once: true });
      cancel = () => stop.removeEventListener('abort', count);
    });
    try {
      return await Promise.race([asked.then(() => true), late]);
    } finally {
      cancel();
    }
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
    if (isUnfit || this.settings)
      return new ConnectionError('bad-settings', 'the port does not take these settings', error);
    return new ConnectionError('busy', 'the port cannot be opened', error);
  }
}
