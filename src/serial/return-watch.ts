import type { Clock } from '../line/index.js';
import { pause } from './pause.js';
import { portKey } from './ports.js';
import type { SerialLike, SerialPortLike } from './types.js';

/**
 * Milliseconds between two looks for the port.
 * Looking helps only when an event was missed, as during the sleep of a computer.
 */
const LOOK_EVERY = 3000;

/**
 * Waits for a lost port to return: the same object, or another one with the same information that was not there at the
 * loss. Make it at the moment of the loss, so that it misses nothing.
 */
export class ReturnWatch {
  readonly #lost: SerialPortLike;
  readonly #serial: SerialLike | undefined;
  readonly #clock: Clock;
  /** Ports that were already there. */
  readonly #others: Promise<Set<SerialPortLike>>;
  readonly #gone = new AbortController();
  #returned: SerialPortLike | null = null;
  #wake = new AbortController();

  /** @param serial without it, only the port itself is watched. */
  constructor(lost: SerialPortLike, serial: SerialLike | undefined, clock: Clock) {
    this.#lost = lost;
    this.#serial = serial;
    this.#clock = clock;
    this.#others = this.#ports().then((ports) => new Set(ports));
    lost.addEventListener('connect', this.#onConnect);
    lost.addEventListener('disconnect', this.#onDisconnect);
    serial?.addEventListener?.('connect', this.#onConnect);
  }

  /** Whether the port is still plugged in. */
  async isThere(): Promise<boolean> {
    // Browsers without `connected` list the ports that are plugged in.
    return this.#lost.connected ?? (await this.#ports()).includes(this.#lost);
  }

  /** Aborted once the browser says that the plug was pulled, or is in again. The stream may fail before that. */
  get gone(): AbortSignal {
    return this.#gone.signal;
  }

  /** @returns the port to open; null when the signal asked to stop first. */
  async returned(signal: AbortSignal): Promise<SerialPortLike | null> {
    const wake = (): void => this.look();
    signal.addEventListener('abort', wake);
    try {
      for (;;) {
        this.#wake = new AbortController();
        if (signal.aborted) return null;
        const returned = this.#returned;
        const waiting = pause(this.#clock, LOOK_EVERY, this.#wake.signal);
        // A browser may never say which ports it has.
        const isBack = returned && returned.connected !== false;
        const found = isBack ? returned : await Promise.race([this.#find(), waiting]);
        if (found) {
          this.look();
          return signal.aborted ? null : found;
        }
        await waiting;
      }
    } finally {
      signal.removeEventListener('abort', wake);
    }
  }

  /** Looks at once. */
  look(): void {
    this.#wake.abort();
  }

  end(): void {
    this.#lost.removeEventListener('connect', this.#onConnect);
    this.#lost.removeEventListener('disconnect', this.#onDisconnect);
    this.#serial?.removeEventListener?.('connect', this.#onConnect);
  }

  readonly #onConnect = ({ target }: Event): void => {
    const port = target as unknown as SerialPortLike;
    if (!this.#isAlike(port)) return;
    this.#returned = port;
    this.#gone.abort();
    this.look();
  };

  readonly #onDisconnect = (): void => this.#gone.abort();

  async #find(): Promise<SerialPortLike | undefined> {
    if (await this.isThere()) return this.#lost;
    const others = await this.#others;
    const ports = await this.#ports();
    // A port that was pulled out and plugged in again counts as returned.
    for (const other of others) if (!ports.includes(other)) others.delete(other);
    return ports.find((port) => port.connected !== false && !others.has(port) && this.#isAlike(port));
  }

  async #ports(): Promise<SerialPortLike[]> {
    return (await this.#serial?.getPorts().catch(() => [])) ?? [];
  }

  #isAlike(port: SerialPortLike): boolean {
    return port === this.#lost || portKey(port.getInfo()) === portKey(this.#lost.getInfo());
  }
}
