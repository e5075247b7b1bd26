/** Where time comes from. Nothing in the rooms above reads another clock, so that tests can turn it by hand. */
export interface Clock {
  /** Milliseconds since 1970, never running backwards. */
  now(): number;
  /**
   * Calls `callback` once, `ms` milliseconds from now, never before this call has returned. A time below 0 is as 0.
   * @returns a function that cancels the call. It does no harm afterwards.
   */
  after(ms: number, callback: () => void): () => void;
}

// What every JavaScript engine has, whether or not the DOM's types are there to say so.
declare function setTimeout(callback: () => void, ms: number): number;
declare function clearTimeout(timer: number): void;
declare const performance: { readonly timeOrigin: number; now(): number };
declare const MessageChannel: new () => {
  port1: { onmessage: (() => void) | null; close(): void };
  port2: { postMessage(message: null): void };
};

/** The real clock. */
export const realClock: Clock = {
  now: () => performance.timeOrigin + performance.now(),
  after(ms, callback) {
    // Some engines warn of a time that is over.
    const timer = setTimeout(callback, Math.max(0, ms));
    return () => clearTimeout(timer);
  },
};

/** Lets every promise that can settle without the clock do so. */
function settle(): Promise<void> {
  const { setImmediate } = globalThis as { setImmediate?: (callback: () => void) => void };
  if (setImmediate) return new Promise((resolve) => setImmediate(resolve));
  return new Promise((resolve) => {
    const channel = new MessageChannel();
    channel.port1.onmessage = () => {
      channel.port1.close();
      resolve();
    };
    channel.port2.postMessage(null);
  });
}

interface Appointment {
  readonly at: number;
  readonly callback: () => void;
}

/**
 * A clock that stands still until it is turned by hand.
 * @example
 * ```ts
 * import { VirtualClock } from 'sidus-timer/line';
 *
 * const clock = new VirtualClock();
 * clock.after(60_000, () => console.log('a minute')); // a minute
 * await clock.advance(60_000);
 * ```
 */
export class VirtualClock implements Clock {
  #now: number;
  /** In the order in which they come due; equal times in the order in which they were made. */
  readonly #appointments: Appointment[] = [];

  /** @param start milliseconds since 1970 at which the clock stands at first. */
  constructor(start = 0) {
    this.#now = start;
  }

  now(): number {
    return this.#now;
  }

  after(ms: number, callback: () => void): () => void {
    const appointment: Appointment = { at: this.#now + Math.max(0, ms), callback };
    let index = this.#appointments.length;
    while (index > 0 && (this.#appointments[index - 1] as Appointment).at > appointment.at) index--;
    this.#appointments.splice(index, 0, appointment);
    return () => {
      const found = this.#appointments.indexOf(appointment);
      if (found >= 0) this.#appointments.splice(found, 1);
    };
  }

  /**
   * Turns the clock forward by `ms` milliseconds, keeping each appointment at its time and letting promises settle
   * between.
   */
  async advance(ms: number): Promise<void> {
    const end = this.#now + ms;
    await settle();
    while (this.#appointments[0] && this.#appointments[0].at <= end) {
      this.#keepNext();
      await settle();
    }
    this.#now = end;
  }

  /**
   * Turns the clock from appointment to appointment until `promise` settles.
   * @returns what the promise gives.
   * @throws Error when nothing is left that could settle it; what the promise throws.
   */
  async run<T>(promise: Promise<T>): Promise<T> {
    let settled = false;
    const done = (): void => {
      settled = true;
    };
    promise.then(done, done);
    await settle();
    while (!settled) {
      if (!this.#appointments[0]) throw new Error('Nothing is due on the clock, and the promise has not settled.');
      this.#keepNext();
      await settle();
    }
    return promise;
  }

  #keepNext(): void {
    const next = this.#appointments.shift() as Appointment;
    this.#now = Math.max(this.#now, next.at);
    next.callback();
  }
}
