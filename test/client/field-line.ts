import type { BytePort } from '../../src/client/index.js';
import type { VirtualClock } from '../../src/line/index.js';
import type { VirtualTimer } from '../../src/simulator/index.js';

export type Direction = 'out' | 'in';

/** What happens to one byte, and to the line at that moment. */
export interface Fault {
  /** What arrives in place of the byte. Default: the byte. */
  readonly bytes?: (byte: number) => readonly number[];
  /** For how many milliseconds this byte, and all bytes after it, are delayed. */
  readonly delay?: number;
  /** What happens to the whole line just before the byte passes. */
  readonly event?: 'cut' | 'gone' | 'asleep';
}

interface Way {
  /** How many bytes have come this way so far. */
  count: number;
  heldUntil: number;
  readonly deliver: (bytes: Uint8Array) => void;
}

interface Page {
  /** The reading end; null when nobody reads. */
  controller: ReadableStreamDefaultController<Uint8Array> | null;
}

/**
 * The line between a page and a timer in the field. A test can set off one fault at any byte of either direction. The
 * line can be opened again after it was cut, or after its page has gone.
 */
export class FieldLine {
  readonly timer: VirtualTimer;
  /** Settles when the line was cut or the page is gone. */
  readonly lost: Promise<void>;
  readonly #clock: VirtualClock;
  readonly #ways: Readonly<Record<Direction, Way>>;
  #armed: { readonly direction: Direction; readonly index: number; readonly fault: Fault } | null = null;
  #lose: () => void = () => {};
  /** The page that has opened the line. */
  #page: Page = { controller: null };

  constructor(timer: VirtualTimer, clock: VirtualClock) {
    this.timer = timer;
    this.#clock = clock;
    this.lost = new Promise((resolve) => {
      this.#lose = resolve;
    });
    const toTimer = timer.writable.getWriter();
    const fromTimer = timer.readable.pipeTo(new WritableStream({ write: (bytes) => this.#pass('in', bytes) }));
    void fromTimer;
    this.#ways = {
      out: { count: 0, heldUntil: 0, deliver: (bytes) => void toTimer.write(bytes) },
      in: { count: 0, heldUntil: 0, deliver: (bytes) => this.#page.controller?.enqueue(bytes) },
    };
  }

  /** Opens the line for a new page, which gets the timer's bytes from now on. */
  open(): BytePort {
    const page: Page = { controller: null };
    this.#page = page;
    return {
      readable: new ReadableStream({
        start: (controller) => {
          page.controller = controller;
        },
        cancel: () => {
          page.controller = null;
        },
      }),
      writable: new WritableStream({
        write: (bytes: Uint8Array, controller) => {
          if (this.#page === page) this.#pass('out', bytes);
          else controller.error(new Error('The line is cut.'));
        },
      }),
    };
  }

  /** Lets the page receive bytes that no timer has sent. */
  disturb(bytes: Uint8Array): void {
    this.#page.controller?.enqueue(bytes);
  }

  /** Sets off a fault at a byte, counted from now on. */
  arm(direction: Direction, index: number, fault: Fault): void {
    this.#armed = { direction, index: this.#ways[direction].count + index, fault };
  }

  /** Whether the fault is still to come. */
  get isArmed(): boolean {
    return this.#armed !== null;
  }

  /** Bytes that went in each direction. */
  get counts(): Record<Direction, number> {
    return { out: this.#ways.out.count, in: this.#ways.in.count };
  }

  #pass(direction: Direction, bytes: Uint8Array): void {
    const way = this.#ways[direction];
    const first = way.count;
    way.count += bytes.length;
    const armed = this.#armed;
    const at = armed?.direction === direction ? armed.index - first : -1;
    if (!armed || at < 0 || at >= bytes.length) {
      this.#deliver(way, bytes);
      return;
    }
    this.#armed = null;
    const { bytes: change = (byte) => [byte], delay = 0, event } = armed.fault;
    this.#deliver(way, bytes.slice(0, at));
    if (event === 'asleep') this.timer.core.sleep();
    if (event === 'cut') {
      this.#cut();
      return;
    }
    way.heldUntil = Math.max(way.heldUntil, this.#clock.now() + delay);
    this.#deliver(way, Uint8Array.of(...change(bytes[at] as number), ...bytes.subarray(at + 1)));
    if (event === 'gone') this.#leave();
  }

  #deliver(way: Way, bytes: Uint8Array): void {
    if (bytes.length === 0) return;
    const held = way.heldUntil - this.#clock.now();
    if (held <= 0) way.deliver(bytes);
    else this.#clock.after(held, () => way.deliver(bytes));
  }

  #cut(): void {
    const { controller } = this.#page;
    this.#leave();
    controller?.error(new Error('The line is cut.'));
  }

  /** The page has gone without closing the line. Nobody reads until the line is opened again. */
  #leave(): void {
    this.#page = { controller: null };
    this.#lose();
  }
}
