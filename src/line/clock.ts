import { requireNumber } from './require.js';

/** Where time comes from. No room above this one reads another clock, so tests can turn time by hand. */
export interface Clock {
  /** Milliseconds since 1970. Never runs backwards. */
  now(): number;
  /**
   * Calls `callback` once, `ms` milliseconds from now, never before this call has returned. A negative time counts as
   * 0.
   * @returns a function that cancels the call. Calling it later, or again, does no harm.
   */
  after(ms: number, callback: () => void): () => void;
  /**
   * Milliseconds since 1970, as the computer shows them. This goes on while the computer sleeps, when `now` may stand
   * still; but somebody can set it. It only serves to notice a sleep. Without it `now` must go on.
   */
  wall?(): number;
}

// Declared here, so that this room needs neither the types of the DOM nor those of Node.
declare function setTimeout(callback: () => void, ms: number): number;
declare function clearTimeout(timer: number): void;
declare function queueMicrotask(callback: () => void): void;
declare const performance: { readonly timeOrigin: number; now(): number };
declare const MessageChannel: new () => {
  port1: { onmessage: (() => void) | null; close(): void };
  port2: { postMessage(message: null): void };
};

/** The real clock. */
export const realClock: Clock = {
  now: () => performance.timeOrigin + performance.now(),
  after(ms, callback) {
    // Some engines warn about a negative delay.
    const timer = setTimeout(callback, Math.max(0, ms));
    return () => clearTimeout(timer);
  },
  wall: () => Date.now(),
};

/** Calls back in this turn, after the caller has gone on. @returns a function that cancels the call. */
export function soon(callback: () => void): () => void {
  let isDue = true;
  queueMicrotask(() => {
    if (isDue) callback();
  });
  return () => {
    isDue = false;
  };
}

/** Waits until every promise that does not depend on the clock has settled. */
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
 * A clock that stands still until a test turns it.
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
  /** Ordered by due time, then by the order in which they were made. */
  readonly #appointments: Appointment[] = [];

  /**
   * @param start what the clock shows at first, in milliseconds since 1970.
   * @throws RangeError when it is no number.
   */
  constructor(start = 0) {
    requireNumber(start, 'start');
    this.#now = start;
  }

  /** What the clock shows, in milliseconds since 1970. */
  now(): number {
    return this.#now;
  }

  /**
   * Calls `callback` once the clock is turned `ms` milliseconds further. Equal times keep their order.
   * @throws RangeError when `ms` is no number.
   */
  after(ms: number, callback: () => void): () => void {
    requireNumber(ms, 'ms');
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
   * Turns the clock forward by `ms` milliseconds. Each callback runs at its own time, and promises settle in between.
   * @throws RangeError when `ms` is negative or no number.
   */
  async advance(ms: number): Promise<void> {
    requireNumber(ms, 'ms', 0);
    const end = this.#now + ms;
    await settle();
    while (this.#appointments[0] && this.#appointments[0].at <= end) {
      this.#keepNext();
      await settle();
    }
    this.#now = end;
  }

  /**
   * Turns the clock from callback to callback until `promise` settles.
   * @returns the value of the promise.
   * @throws whatever the promise rejects with; Error when it is still pending and no callback is left.
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
