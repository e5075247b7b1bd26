import { type Clock, realClock, soon } from '../../line/index.js';
import type { CaptureEntry } from '../../protocol/index.js';
import type { SerialPortLike } from '../../serial/index.js';
import { exampleMemories, ReplayTimer, type TimerCore, VirtualTimer } from '../../simulator/index.js';
import type { SimulatedClass } from '../work/timer-access.js';

/** A line as over infrared: bits a second, and how many milliseconds an adapter and a timer take to answer. */
const LINE = { baudRate: 9600, latency: 40 };

/**
 * The clock of line and timer. In the background a browser calls timeouts once a second at most, but the bytes of a
 * real port come in time there, too. So there the bytes of a simulated timer take no time.
 */
const promptInBackground: Clock = {
  ...realClock,
  after: (ms, callback) => (document.hidden ? soon(callback) : realClock.after(ms, callback)),
};

/** What the timer of each class holds until the page is closed: a pilot connects again to see what was written. */
const held = new Map<SimulatedClass, TimerCore>();

/** A port whose cable ends at a timer in this page, which has the time of its line itself. */
class TimerPort extends EventTarget implements SerialPortLike {
  readable: ReadableStream<Uint8Array> | null = null;
  writable: WritableStream<Uint8Array> | null = null;
  readonly #toTimer: WritableStreamDefaultWriter<Uint8Array>;
  #page: ReadableStreamDefaultController<Uint8Array> | null = null;

  constructor(timer: VirtualTimer | ReplayTimer) {
    super();
    this.#toTimer = timer.writable.getWriter();
    void timer.readable.pipeTo(new WritableStream({ write: (bytes) => this.#page?.enqueue(bytes) }));
  }

  async open(): Promise<void> {
    this.readable = new ReadableStream({
      start: (page) => {
        this.#page = page;
      },
      cancel: () => {
        this.#page = null;
      },
    });
    this.writable = new WritableStream({ write: (bytes) => this.#toTimer.write(bytes) });
  }

  async close(): Promise<void> {
    this.readable = this.writable = this.#page = null;
  }

  getInfo() {
    return {};
  }
}

/**
 * A virtual timer with the speed of a real line. The first of its class has example memories, each later one what the
 * one before held. It takes the same path through the code as a real timer.
 */
export function plugSimulatedTimer(timerClass: SimulatedClass): SerialPortLike {
  const last = held.get(timerClass);
  const memories = last?.memories ?? exampleMemories(timerClass);
  const timer = new VirtualTimer({ identity: { timerClass }, memories, clock: promptInBackground, ...LINE });
  const { core } = timer;
  if (last) [core.memory, core.idleThrottle] = [last.memory, last.idleThrottle];
  held.set(timerClass, core);
  return new TimerPort(timer);
}

/** A recorded timer, with the times of its recording. */
export function plugRecording(entries: readonly CaptureEntry[]): SerialPortLike {
  return new TimerPort(new ReplayTimer(entries));
}
