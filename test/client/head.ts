import type { BytePort } from '../../src/client/index.js';
import type { VirtualTimer } from '../../src/simulator/index.js';

/** A timer of which few bytes say all. */
export const SMALL = { functions: 2, memories: 2, servos: 1 };
/** Before the two SETs of a write: GETSWVER, GETMEMORY, GETTIMERS, GETSERVOPOS, GETMEMORY, GETSWVER. */
export const FRESH = 6;
export const SETS = 2;
export const VERIFY = 8;

/** An infrared head that is held over one of several timers. */
export class Head implements BytePort {
  readonly readable: ReadableStream<Uint8Array>;
  readonly writable: WritableStream<Uint8Array>;
  at: VirtualTimer;
  requests = 0;
  /** Called with each request that goes out. False: nobody hears it. */
  asked: () => unknown = () => {};
  protected deliver: (bytes: Uint8Array) => void = () => {};

  constructor(...timers: readonly [VirtualTimer, ...VirtualTimer[]]) {
    this.at = timers[0];
    this.readable = new ReadableStream({
      start: (controller) => {
        this.deliver = (bytes) => controller.enqueue(bytes);
        for (const timer of timers) {
          const hear = (bytes: Uint8Array): void => void (timer === this.at && this.hear(bytes));
          void timer.readable.pipeTo(new WritableStream({ write: hear }));
        }
      },
    });
    const writers = new Map(timers.map((timer) => [timer, timer.writable.getWriter()]));
    this.writable = new WritableStream({
      write: (bytes) => {
        this.requests++;
        return this.asked() === false ? undefined : writers.get(this.at)?.write(bytes);
      },
    });
  }

  protected hear(bytes: Uint8Array): void {
    this.deliver(bytes);
  }
}
